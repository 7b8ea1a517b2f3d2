#include "fem/pixel_solver.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "fem/grid_multigrid.h"
#include "fem/pixel_stress.h"
#include "support/sheets.h"

namespace bead {
namespace {

using test::gap;
using test::product;
using test::random_load;
using test::random_sheet;
using test::random_vector;
using test::size_of;

RC_GTEST_PROP(PixelStiffness, is_symmetric, (unsigned seed)) {
    const PixelModel model = random_sheet(9, 6, seed);
    const PixelVector u = random_vector(2 * model.grid.nodes(), seed + 1);
    const PixelVector w = random_vector(2 * model.grid.nodes(), seed + 2);
    const double a = product(u, forces(model, w)), b = product(w, forces(model, u));
    RC_ASSERT(std::abs(a - b) < 1e-10 * size_of(u) * size_of(w) * 2200);
}

RC_GTEST_PROP(PixelStiffness, rigid_motions_need_no_force, (unsigned seed)) {
    PixelModel model = random_sheet(9, 6, seed);
    model.laws.assign(model.factor.size(), bars(900, unit(0.4)) + isotropic(100, 0.3));
    PixelVector x(2 * model.grid.nodes(), 0.0), y = x, turn = x;
    for (std::size_t node = 0; node < model.grid.nodes(); ++node) {
        const Vec2 p = model.grid.place(node);
        x[2 * node] = y[2 * node + 1] = 1;
        turn[2 * node] = -p.y;
        turn[2 * node + 1] = p.x;
    }
    for (const PixelVector& motion : {x, y, turn})
        RC_ASSERT(size_of(forces(model, motion)) < 1e-10 * 2200 * size_of(motion));
}

RC_GTEST_PROP(PixelSolver, answers_are_reciprocal, (unsigned seed)) {
    const PixelModel model = random_sheet(12, 8, seed);
    const PixelSolver solver(model, test::left_side_held(model.grid));
    RC_ASSERT(!solver.loose_node());
    const PixelVector f = random_load(model, seed + 1), g = random_load(model, seed + 2);
    const Displacement u = solver.solve(f), w = solver.solve(g);
    RC_ASSERT(u.converged && u.residual < 1e-9);
    const double a = work(f, w.values), b = work(g, u.values);
    RC_ASSERT(std::abs(a - b) < 1e-9 * (std::abs(a) + std::abs(b) + work(f, u.values)));
    // Energy is half of force times displacement, pixel by pixel.
    double energy = 0;
    for (const double e : pixel_energy(model, u.values)) energy += e;
    const PixelVector reaction = reactions(model, solver.held(), f, u.values);
    RC_ASSERT(std::abs(energy - work(f, u.values)) < 1e-9 * energy);
    RC_ASSERT(work(reaction, u.values) == 0);
}

RC_GTEST_PROP(PixelSolver, supports_give_what_loads_take, (unsigned seed)) {
    const PixelModel model = random_sheet(12, 8, seed);
    const PixelSolver solver(model, test::left_side_held(model.grid));
    const PixelVector f = random_load(model, seed + 1);
    const PixelVector r = reactions(model, solver.held(), f, solver.solve(f).values);
    Vec2 sum;
    double moment = 0, scale = 0;
    for (std::size_t node = 0; node < model.grid.nodes(); ++node) {
        const Vec2 force{f[2 * node] + r[2 * node], f[2 * node + 1] + r[2 * node + 1]};
        sum = sum + force;
        moment += cross(model.grid.place(node), force);
        scale += length(force);
    }
    RC_ASSERT(length(sum) < 1e-9 * scale);
    RC_ASSERT(std::abs(moment) < 1e-8 * scale);
}

TEST(PixelSolver, ScalesWithStiffnessAndThickness) {
    PixelModel model = random_sheet(12, 8, 3);
    const Held held = test::left_side_held(model.grid);
    const PixelVector f = random_load(model, 4);
    const PixelVector u = PixelSolver(model, held).solve(f).values;
    model.law = 3 * model.law;
    model.thickness *= 5;
    PixelVector stiffer = PixelSolver(model, held).solve(f).values;
    for (double& value : stiffer) value *= 15;
    EXPECT_LT(gap(u, stiffer), 1e-9 * size_of(u));
}

// A quarter turn takes pixel (i, j) of a square to (n - 1 - j, i).
TEST(PixelSolver, DoesNotCareForDirectionOrPlace) {
    const int n = 9;
    PixelModel model = random_sheet(n, n, 5), turned = model;
    turned.grid.origin = {100, -40};
    const Held held = test::left_side_held(model.grid);
    const PixelVector f = random_load(model, 6);
    Held held_turned(held.size(), 0);
    PixelVector f_turned(f.size(), 0.0);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            turned.factor[turned.grid.pixel(n - 1 - j, i)] = model.factor[model.grid.pixel(i, j)];
    const auto image = [&](int i, int j) { return turned.grid.node(n - j, i); };
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const std::size_t from = model.grid.node(i, j), to = image(i, j);
            held_turned[2 * to] = held[2 * from + 1];
            held_turned[2 * to + 1] = held[2 * from];
            f_turned[2 * to] = -f[2 * from + 1];
            f_turned[2 * to + 1] = f[2 * from];
        }
    const PixelVector u = PixelSolver(model, held).solve(f).values;
    const PixelVector w = PixelSolver(turned, held_turned).solve(f_turned).values;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const std::size_t from = model.grid.node(i, j), to = image(i, j);
            EXPECT_NEAR(w[2 * to], -u[2 * from + 1], 1e-10 * size_of(u));
            EXPECT_NEAR(w[2 * to + 1], u[2 * from], 1e-10 * size_of(u));
        }
}

TEST(PixelSolver, ConstantStressIsExact) {
    const PixelModel model = test::sheet(7, 5, 0.5);
    PixelVector u(2 * model.grid.nodes());
    for (std::size_t node = 0; node < model.grid.nodes(); ++node) {
        const Vec2 p = model.grid.place(node);
        u[2 * node] = 1e-3 * (p.x + p.y / 2);
        u[2 * node + 1] = 1e-3 * (p.y + p.x / 2);
    }
    const PlaneTensor wanted = stress_of(model.law, {1e-3, 1e-3, 1e-3});
    for (const auto& field : {centre_stress(model, u), node_stress(model, u)})
        for (const PlaneTensor& s : field) {
            EXPECT_NEAR(s.xx, wanted.xx, 1e-12);
            EXPECT_NEAR(s.yy, wanted.yy, 1e-12);
            EXPECT_NEAR(s.xy, wanted.xy, 1e-12);
        }
}

TEST(PixelSolver, FewPixelsMoreNeedFewIterations) {
    PixelModel model = test::sheet(60, 20);
    for (int j = 5; j < 15; ++j)
        for (int i = 10; i < 50; ++i) model.factor[model.grid.pixel(i, j)] = 0;
    const PixelSolver solver(model, test::left_side_held(model.grid));
    PixelModel braced = model;
    for (int k = 0; k < 10; ++k)
        for (const int w : {0, 1}) braced.factor[model.grid.pixel(20 + k + w, 5 + k)] = 1;
    const PixelVector f = random_load(model, 8);
    const Displacement near = solver.solve_changed(braced, f);
    const Displacement exact = PixelSolver(braced, solver.held()).solve(f);
    EXPECT_TRUE(near.converged);
    EXPECT_LT(near.iterations, 150);
    EXPECT_LT(gap(near.values, exact.values), 1e-6 * size_of(exact.values));
}

TEST(PixelSolver, NamesWhatIsLoose) {
    const PixelModel model = test::sheet(6, 4);
    Held held(2 * model.grid.nodes(), 0);
    held[0] = held[1] = 1;  // one point: it may still turn
    EXPECT_TRUE(PixelSolver(model, held).loose_node().has_value());
}

TEST(Multigrid, AgreesWithTheDirectSolver) {
    for (const unsigned seed : {1U, 2U}) {
        PixelModel model = random_sheet(90, 61, seed);
        for (double& factor : model.factor) factor = double(float(factor));
        const Held held = test::left_side_held(model.grid);
        const PixelVector f = random_load(model, seed + 5);
        ElasticGrid grid{2, {90, 61, 0}, {}, model.thickness * model.law, 0, 0};
        grid.factor.assign(model.factor.begin(), model.factor.end());
        const Displacement by_cycles = multigrid_solution(grid, held, f, {.tolerance = 1e-10});
        EXPECT_TRUE(by_cycles.converged) << by_cycles.iterations << " " << by_cycles.residual;
        const Displacement direct = PixelSolver(model, held).solve(f);
        EXPECT_LT(gap(by_cycles.values, direct.values), 1e-6 * size_of(direct.values));
    }
}

TEST(Multigrid, SaysHowFarItCame) {
    const PixelModel model = test::sheet(200, 100);
    ElasticGrid grid{2, {200, 100, 0}, {}, model.law, 0, 0};
    grid.factor.assign(model.factor.begin(), model.factor.end());
    const Displacement u = multigrid_solution(grid, test::left_side_held(model.grid),
                                              random_load(model, 1), {.most = 2});
    EXPECT_FALSE(u.converged);
    EXPECT_EQ(u.iterations, 2);
    EXPECT_GT(u.residual, 1e-8);
}

}  // namespace
}  // namespace bead
