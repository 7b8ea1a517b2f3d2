#include "fem/plane_element.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/plane_solver.h"
#include "fem/region_mesh.h"

namespace bead {
namespace {

constexpr PlaneElement kinds[]{PlaneElement::q4, PlaneElement::q8, PlaneElement::t6};

// MacNeal and Harder (1985): five skew quadrilaterals in a rectangle.
PlaneMesh patch(PlaneElement kind) {
    const Vec2 corner[]{{0, 0},       {0.24, 0},    {0.24, 0.12}, {0, 0.12},
                        {0.04, 0.02}, {0.18, 0.03}, {0.16, 0.08}, {0.08, 0.08}};
    const std::vector<std::vector<int>> quads{
        {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
    std::vector<std::vector<int>> cells;
    for (const auto& q : quads) {
        if (kind != PlaneElement::t6)
            cells.push_back(q);
        else
            for (const auto& t : {std::vector{q[0], q[1], q[2]}, std::vector{q[0], q[2], q[3]}})
                cells.push_back(t);
    }
    PlaneMesh mesh{kind, {std::begin(corner), std::end(corner)}, {}, {}};
    const auto middle = [&](int a, int b) {
        const Vec2 p = 0.5 * (corner[a] + corner[b]);
        for (std::size_t i = 8; i < mesh.nodes.size(); ++i)
            if (distance(mesh.nodes[i], p) < 1e-12) return int(i);
        mesh.nodes.push_back(p);
        return int(mesh.nodes.size()) - 1;
    };
    for (const auto& cell : cells) {
        mesh.elements.insert(mesh.elements.end(), cell.begin(), cell.end());
        if (kind == PlaneElement::q4) continue;
        for (std::size_t k = 0; k < cell.size(); ++k)
            mesh.elements.push_back(middle(cell[k], cell[(k + 1) % cell.size()]));
    }
    return mesh;
}

TEST(PlaneElements, PassThePatchTest) {
    const PlaneLaw law = isotropic(1e6, 0.25);
    for (const PlaneElement kind : kinds) {
        const PlaneMesh mesh = patch(kind);
        std::vector<std::uint8_t> held(2 * mesh.nodes.size(), 0);
        std::vector<double> given(held.size(), 0.0), load(held.size(), 0.0);
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            const Vec2 p = mesh.nodes[n];
            const bool rim = p.x < 1e-9 || p.x > 0.24 - 1e-9 || p.y < 1e-9 || p.y > 0.12 - 1e-9;
            if (rim) held[2 * n] = held[2 * n + 1] = 1;
            given[2 * n] = 1e-3 * (p.x + p.y / 2);
            given[2 * n + 1] = 1e-3 * (p.y + p.x / 2);
        }
        std::vector<double> on_rim = given;
        for (std::size_t i = 0; i < held.size(); ++i)
            if (held[i] == 0) on_rim[i] = 0;
        const PlaneSolver solver(mesh, law, 0.001, held);
        const Displacement u = solver.solve_moved(load, on_rim);
        for (std::size_t i = 0; i < given.size(); ++i)
            EXPECT_NEAR(u.values[i] / 1e-3, given[i] / 1e-3, 1e-12);
        for (const PlaneTensor& s : node_stress(mesh, law, u.values)) {
            EXPECT_NEAR(s.xx / (4000.0 / 3), 1, 1e-12);
            EXPECT_NEAR(s.yy / (4000.0 / 3), 1, 1e-12);
            EXPECT_NEAR(s.xy / 400, 1, 1e-12);
        }
    }
}

TEST(PlaneElements, StiffnessIsSymmetricAndFreeForRigidMotions) {
    const PlaneLaw law = isotropic(2, 0.3) + bars(3, unit(0.7));
    for (const PlaneElement kind : kinds) {
        const PlaneMesh mesh = patch(kind);
        const auto size = std::size_t(2 * nodes_of(kind));
        std::vector<double> k(size * size);
        for (std::size_t e = 0; e < mesh.count(); ++e) {
            const auto places = mesh.places(e);
            stiffness(kind, places, law, k);
            for (std::size_t i = 0; i < size; ++i) {
                double x = 0, y = 0, turn = 0;
                for (std::size_t j = 0; j < size; ++j) {
                    EXPECT_NEAR(k[i * size + j], k[j * size + i], 1e-13);
                    (j % 2 == 0 ? x : y) += k[i * size + j];
                    turn += k[i * size + j] * (j % 2 == 0 ? -places[j / 2].y : places[j / 2].x);
                }
                EXPECT_NEAR(x, 0, 1e-12);
                EXPECT_NEAR(y, 0, 1e-12);
                EXPECT_NEAR(turn, 0, 1e-12);
            }
        }
    }
}

// A map's mesh with the left side held and the right one pulled; the displacement of a corner.
struct Pulled {
    PlaneMesh mesh;
    Displacement u;
    double work = 0;
};

Pulled pulled(PlaneElement kind, int columns, int rows, const std::function<Vec2(Vec2)>& map,
              const PlaneLaw& law, double thickness, Vec2 force) {
    Pulled p{structured_mesh(kind, columns, rows, map), {}, 0};
    std::vector<std::uint8_t> held(2 * p.mesh.nodes.size(), 0);
    std::vector<double> load(held.size(), 0.0);
    for (const MeshSide& side : p.mesh.sides) {
        if (side.from >= 3)
            for (const int n : {side.begin, side.end, side.middle})
                if (n >= 0) held[2 * std::size_t(n)] = held[2 * std::size_t(n) + 1] = 1;
        if (side.from < 1 || side.to > 2) continue;
        const double share = side.to - side.from;
        const auto add = [&](int n, double part) {
            load[2 * std::size_t(n)] += part * force.x;
            load[2 * std::size_t(n) + 1] += part * force.y;
        };
        add(side.begin, side.middle < 0 ? share / 2 : share / 6);
        add(side.end, side.middle < 0 ? share / 2 : share / 6);
        if (side.middle >= 0) add(side.middle, share * 2 / 3);
    }
    p.u = PlaneSolver(p.mesh, law, thickness, held).solve(load);
    for (std::size_t i = 0; i < load.size(); ++i) p.work += load[i] * p.u.values[i];
    return p;
}

double moved_y(const Pulled& p, Vec2 at) {
    for (std::size_t n = 0; n < p.mesh.nodes.size(); ++n)
        if (distance(p.mesh.nodes[n], at) < 1e-9) return p.u.values[2 * n + 1];
    return std::nan("");
}

// Cook's membrane: 23.966 at (48, 52) by triangles of ever smaller size.
TEST(PlaneElements, BendCooksMembrane) {
    const auto map = [](Vec2 s) {
        return Vec2{48 * s.x, lerp(Vec2{0, 44}, Vec2{44, 60}, s.x).x +
                                  s.y * lerp(Vec2{44, 0}, Vec2{16, 0}, s.x).x};
    };
    const PlaneLaw law = isotropic(1, 1.0 / 3);
    for (const PlaneElement kind : {PlaneElement::q8, PlaneElement::t6}) {
        const Pulled p = pulled(kind, 32, 32, map, law, 1, {0, 1});
        EXPECT_NEAR(moved_y(p, {48, 52}), 23.966, 0.02);
    }
    const Pulled q4 = pulled(PlaneElement::q4, 64, 64, map, law, 1, {0, 1});
    EXPECT_NEAR(moved_y(q4, {48, 52}), 23.966, 0.1);
}

// One element deep, six long; the slender beam of MacNeal and Harder.
TEST(PlaneElements, OfSecondOrderBendASlenderBeam) {
    const auto map = [](Vec2 s) { return Vec2{6 * s.x, 0.2 * s.y}; };
    const PlaneLaw law = isotropic(1e7, 0.3);
    const Pulled bent = pulled(PlaneElement::q8, 6, 1, map, law, 0.1, {0, 1});
    EXPECT_NEAR(bent.work, 0.1081, 0.02 * 0.1081);
    const Pulled pulled_out = pulled(PlaneElement::q8, 6, 1, map, law, 0.1, {1, 0});
    EXPECT_NEAR(pulled_out.work, 3e-5, 0.01 * 3e-5);
    const Pulled triangles = pulled(PlaneElement::t6, 12, 2, map, law, 0.1, {0, 1});
    EXPECT_NEAR(triangles.work, 0.1081, 0.01 * 0.1081);
}

// Lamé's ring under pressure from within, a quarter of it; the largest error of hoop stress along
// the middle of the ring.
double ring_error(PlaneElement kind, int n) {
    const double inner = 10, outer = 20;
    const PlaneMesh mesh = structured_mesh(
        kind, n, n, [&](Vec2 s) { return (inner + (outer - inner) * s.x) * unit(pi / 2 * s.y); });
    std::vector<std::uint8_t> held(2 * mesh.nodes.size(), 0);
    std::vector<double> load(held.size(), 0.0);
    for (const MeshSide& side : mesh.sides) {
        const std::array nodes{side.begin, side.end, side.middle};
        if (side.to <= 1)
            for (const int k : nodes)
                if (k >= 0) held[2 * std::size_t(k) + 1] = 1;
        if (side.from >= 2 && side.to <= 3)
            for (const int k : nodes)
                if (k >= 0) held[2 * std::size_t(k)] = 1;
        if (side.from < 3) continue;
        // The exact pressure on the circle, by Simpson or the trapezium.
        const double share = inner * pi / 2 * (side.to - side.from);
        const double part[]{side.middle < 0 ? 0.5 : 1.0 / 6, side.middle < 0 ? 0.5 : 1.0 / 6,
                            2.0 / 3};
        for (std::size_t k = 0; k < 3; ++k) {
            if (nodes[k] < 0) continue;
            const Vec2 p = mesh.nodes[std::size_t(nodes[k])];
            load[2 * std::size_t(nodes[k])] += part[k] * share * p.x / inner;
            load[2 * std::size_t(nodes[k]) + 1] += part[k] * share * p.y / inner;
        }
    }
    const PlaneLaw law = isotropic(1000, 0.3);
    const Displacement u = PlaneSolver(mesh, law, 1, held).solve(load);
    const std::vector<PlaneTensor> stress = node_stress(mesh, law, u.values);
    double worst = 0;
    for (const double angle : {0.3, 0.8, 1.1}) {
        const Vec2 at = 15 * unit(angle);
        const auto place = locate(mesh, at);
        EXPECT_TRUE(place);
        const double hoop = along(stress_at(mesh, stress, *place), left_of(unit(angle)));
        const double exact = 100.0 / 300 * (1 + 400.0 / 225);
        worst = std::max(worst, std::abs(hoop / exact - 1));
    }
    return worst;
}

TEST(PlaneElements, ConvergeOnTheRing) {
    EXPECT_LT(ring_error(PlaneElement::q4, 32), 3e-3);
    EXPECT_LT(ring_error(PlaneElement::q8, 16), 1e-3);
    EXPECT_LT(ring_error(PlaneElement::t6, 16), 1.5e-3);
    for (const PlaneElement kind : kinds)
        EXPECT_GT(ring_error(kind, 8) / ring_error(kind, 32), 8);  // at least second order
}

}  // namespace
}  // namespace bead
