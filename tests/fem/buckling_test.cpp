#include "fem/buckling.h"

#include <gtest/gtest.h>

#include "support/sheets.h"

namespace bead {
namespace {

struct Column {
    PixelSolver solver;
    PixelVector load;
};

// 20 x 1 mm, clamped at the left, pressed from the right by 1 N in all.
Column column(int per_mm) {
    PixelModel model = test::sheet(20 * per_mm, per_mm, 1.0 / per_mm);
    model.thickness = 1;
    model.law = isotropic(1, 0);
    PixelVector load(2 * model.grid.nodes(), 0.0);
    for (int j = 0; j <= per_mm; ++j)
        load[2 * model.grid.node(20 * per_mm, j)] = -(j == 0 || j == per_mm ? 0.5 : 1.0) / per_mm;
    Held held = test::left_side_held(model.grid);
    return {PixelSolver(std::move(model), std::move(held)), std::move(load)};
}

double lowest(int per_mm) {
    const Column c = column(per_mm);
    const Buckling b = buckling(c.solver, c.solver.solve(c.load).values, {.tolerance = 1e-6});
    EXPECT_TRUE(b.converged);
    return b.modes.front().factor;
}

// Known for these pixels from another program; Euler's own value is 5.14042e-4.
TEST(Buckling, OfAColumnIsEulers) {
    EXPECT_NEAR(lowest(4), 5.2923e-4, 1e-8);
    EXPECT_NEAR(lowest(10), 5.1572e-4, 1e-8);
    const double euler = pi * pi / (4 * 400) / 12;
    const double coarse = lowest(4) - euler, fine = lowest(8) - euler;
    EXPECT_GT(coarse / fine, 3.5);  // second order
}

TEST(Buckling, ModesAreOrthonormalInEnergyAndSolveTheirEquation) {
    const Column c = column(6);
    const PixelModel& model = c.solver.model();
    const PixelVector u = c.solver.solve(c.load).values;
    const Buckling b = buckling(c.solver, u, {.count = 3, .tolerance = 1e-8});
    ASSERT_EQ(b.modes.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const PixelVector& shape = b.modes[i].shape;
        const PixelVector k = forces(model, shape);
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_NEAR(test::product(b.modes[j].shape, k), i == j ? 1 : 0, 1e-6);
        const PixelVector g = geometric_forces(model, u, shape);
        EXPECT_NEAR(-b.modes[i].factor * test::product(shape, g), 1, 1e-5);
        if (i > 0) {
            EXPECT_GT(b.modes[i].factor, b.modes[i - 1].factor);
        }
    }
}

TEST(Buckling, PullingHarderIsNoDanger) {
    const Column c = column(4);
    PixelVector u = c.solver.solve(c.load).values;
    for (double& value : u) value = -value;
    const Buckling b = buckling(c.solver, u);
    for (const BucklingMode& mode : b.modes) EXPECT_GT(mode.factor, 100 * 5e-4);
}

}  // namespace
}  // namespace bead
