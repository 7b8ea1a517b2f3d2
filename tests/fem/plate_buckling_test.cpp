#include "fem/plate_buckling.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "fem/plate_element.h"
#include "support/sheets.h"

namespace bead {
namespace {

constexpr double corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

// Corner unknowns of a deflection with its slopes, on a square of side h at the origin.
template <class Shape>
std::array<double, 12> values_of(const Shape& shape, double h) {
    std::array<double, 12> u{};
    for (std::size_t c = 0; c < 4; ++c) {
        const auto [w, wx, wy] = shape(h * corner[c][0], h * corner[c][1]);
        u[3 * c] = w;
        u[3 * c + 1] = h / 2 * wx;
        u[3 * c + 2] = h / 2 * wy;
    }
    return u;
}

double energy(const PlateMatrix& k, const std::array<double, 12>& u) {
    double sum = 0;
    for (std::size_t i = 0; i < 12; ++i)
        for (std::size_t j = 0; j < 12; ++j) sum += u[i] * k[12 * i + j] * u[j];
    return sum;
}

TEST(PlateElement, RigidMotionsAreFree) {
    const PlateMatrix k = plate_stiffness(isotropic(2200, 0.3), 0.7);
    const auto tilted = [](double x, double y) { return std::array{3 + 2 * x - y, 2.0, -1.0}; };
    EXPECT_NEAR(energy(k, values_of(tilted, 0.7)), 0, 1e-9);
}

// Any constant curvature has just its energy.
RC_GTEST_PROP(PlateElement, ConstantCurvatureIsExact, ()) {
    const double a = *rc::gen::inRange(-9, 10), b = *rc::gen::inRange(-9, 10),
                 c = *rc::gen::inRange(-9, 10), h = 0.1 * *rc::gen::inRange(1, 30);
    const auto bowl = [&](double x, double y) {
        return std::array{a * x * x / 2 + b * y * y / 2 + c * x * y, a * x + c * y, b * y + c * x};
    };
    const PlaneLaw d = isotropic(1000, 0.3);
    const PlaneTensor m = stress_of(d, {a, b, 2 * c});
    const double known = (m.xx * a + m.yy * b + m.xy * 2 * c) * h * h;
    RC_ASSERT(std::abs(energy(plate_stiffness(d, h), values_of(bowl, h)) - known) <=
              1e-9 * (1 + known));
}

TEST(PlateElement, ForcesInThePlaneWorkOnSlopes) {
    const auto tilted = [](double x, double y) { return std::array{2 * x - y, 2.0, -1.0}; };
    const PlateMatrix g = plate_geometric_stiffness({5, 7, 3});
    EXPECT_NEAR(energy(g, values_of(tilted, 0.5)), 0.25 * (5 * 4 + 7 * 1 - 2 * 3 * 2), 1e-12);
}

struct Plate {
    PixelModel sheet;
    PlateHeld held;
    std::vector<double> displacement;  // in the plane, by hand
};

// `length` x 1, pressed along x by a stress of 1 MPa; simply supported all round, or held as asked.
Plate pressed_plate(int length, int per_unit) {
    Plate plate;
    plate.sheet = test::sheet(length * per_unit, per_unit, 1.0 / per_unit);
    plate.sheet.law = isotropic(1e4, 0.3);
    plate.sheet.thickness = 0.02;
    const PixelGrid& grid = plate.sheet.grid;
    plate.held.assign(3 * grid.nodes(), 0);
    plate.displacement.resize(2 * grid.nodes());
    for (std::size_t n = 0; n < grid.nodes(); ++n) {
        const Vec2 p = grid.place(n);
        plate.displacement[2 * n] = -p.x / 1e4;
        plate.displacement[2 * n + 1] = 0.3 * p.y / 1e4;
    }
    return plate;
}

void support_edges(Plate& plate) {
    const PixelGrid& grid = plate.sheet.grid;
    for (int j = 0; j <= grid.rows; ++j)
        for (int i = 0; i <= grid.columns; ++i)
            if (i == 0 || j == 0 || i == grid.columns || j == grid.rows)
                plate.held[3 * grid.node(i, j)] = 1;
}

double factor(const Plate& plate) {
    const auto b = plate_buckling(plate.sheet, plate_rigidity(plate.sheet), plate.held,
                                  plate.displacement, {.tolerance = 1e-7});
    EXPECT_TRUE(b && b->converged);
    return b ? b->factor : 0;
}

// k of sigma = k pi² D / (b² t).
double coefficient(const Plate& plate) {
    const double t = plate.sheet.thickness, d = 1e4 * t * t * t / 12 / (1 - 0.09);
    return factor(plate) * t / (pi * pi * d);
}

TEST(PlateBuckling, OfASimplySupportedPlateIsFour) {
    std::vector<double> off;
    for (const int per_unit : {6, 12, 24}) {
        Plate plate = pressed_plate(1, per_unit);
        support_edges(plate);
        off.push_back(std::abs(coefficient(plate) - 4));
    }
    EXPECT_LT(off.back(), 0.012);
    EXPECT_GT(off[0] / off[1], 3.5);  // with the square of the side
    EXPECT_GT(off[1] / off[2], 3.5);
}

// A plate twice as long buckles in two waves, at the same stress; 1.5 times as long at 4.34.
TEST(PlateBuckling, OfALongPlateComesInWaves) {
    Plate plate = pressed_plate(2, 16);
    support_edges(plate);
    EXPECT_NEAR(coefficient(plate), 4, 0.03);
    const auto b = plate_buckling(plate.sheet, plate_rigidity(plate.sheet), plate.held,
                                  plate.displacement, {});
    const PixelGrid& grid = plate.sheet.grid;
    EXPECT_LT(b->deflection[grid.node(8, 8)] * b->deflection[grid.node(24, 8)], 0);
}

// A strip that is held at one end is Euler's column about its flat side (Poisson's ratio 0).
TEST(PlateBuckling, OfAStripIsEulers) {
    Plate plate = pressed_plate(8, 6);
    plate.sheet.law = isotropic(1e4, 0);
    for (double& u : plate.displacement) u *= u > 0 ? 0 : 1;
    const PixelGrid& grid = plate.sheet.grid;
    for (int j = 0; j <= grid.rows; ++j)
        for (std::size_t c = 0; c < 3; ++c) plate.held[3 * grid.node(0, j) + c] = 1;
    const double t = plate.sheet.thickness;
    const double euler = pi * pi * 1e4 * t * t / 12 / (4 * 64);
    EXPECT_NEAR(factor(plate), euler, 0.002 * euler);
}

TEST(PlateBuckling, SaysWhenNothingHolds) {
    Plate plate = pressed_plate(1, 6);
    EXPECT_FALSE(plate_buckling(plate.sheet, plate_rigidity(plate.sheet), plate.held,
                                plate.displacement, {}));
    // One edge alone is a hinge.
    for (int j = 0; j <= 6; ++j) plate.held[3 * plate.sheet.grid.node(0, j)] = 1;
    EXPECT_FALSE(plate_buckling(plate.sheet, plate_rigidity(plate.sheet), plate.held,
                                plate.displacement, {}));
}

TEST(PlateBuckling, PullingIsNoDanger) {
    Plate plate = pressed_plate(1, 8);
    support_edges(plate);
    for (double& u : plate.displacement) u = -u;
    const auto b =
        plate_buckling(plate.sheet, plate_rigidity(plate.sheet), plate.held, plate.displacement);
    ASSERT_TRUE(b);
    EXPECT_EQ(b->factor, 0);
}

// Twice as thick: eight times as stiff against twice the force.
TEST(PlateBuckling, GrowsWithTheSquareOfTheThickness) {
    Plate plate = pressed_plate(1, 8);
    support_edges(plate);
    const double thin = factor(plate);
    plate.sheet.thickness *= 2;
    EXPECT_NEAR(factor(plate) / thin, 4, 1e-6);
}

}  // namespace
}  // namespace bead
