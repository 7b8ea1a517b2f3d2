// What the adjoint foretells is what happens, to first order.
#include "strength/sensitivity.h"

#include <gtest/gtest.h>

#include <random>

#include "fem/pixel_stress.h"
#include "strength/cases.h"
#include "strength/failure_index.h"

namespace bead {
namespace {

constexpr Vec2 size{24, 6};

LoadCase beam_case() {
    LoadCase beam = bar_case(size, {3, -5});
    beam.print.bead_width = 0.6;
    return beam;
}

// Beads along the bar with gaps, and posts: no stress is alike another.
TestRig rig_of(const LoadCase& part) {
    Toolpath layer = solid_bar(size);
    layer.erase(layer.begin() + 3, layer.begin() + 6);
    for (double x = 0.3; x < size.x; x += 4) {
        Path post = layer.front();
        post.points = {{x, 0, 0}, {x, size.y, 0}};
        layer.push_back(post);
    }
    return TestRig::of({&layer, 1}, part, {.pixel = 0.3}).value();
}

TEST(FailureNorm, IsAtLeastTheHighestIndexAndNotMuchMore) {
    const LoadCase part = beam_case();
    const TestRig rig = rig_of(part);
    const std::vector<Tested> tested{rig.tested(0)};
    EXPECT_GE(failure_norm(tested), 1 / tested[0].factor());
    EXPECT_LT(failure_norm(tested), 1.3 / tested[0].factor());
}

TEST(Sensitivity, ForetellsWhatASmallForceChanges) {
    const LoadCase part = beam_case();
    const TestRig rig = rig_of(part);
    const std::vector<Tested> tested{rig.tested(0)};
    const std::vector<PixelVector> adjoint = sensitivity(rig, tested);
    ASSERT_EQ(adjoint.size(), 1U);
    std::mt19937 random(5);
    for (int trial = 0; trial < 10; ++trial) {
        PixelVector force(2 * rig.model().grid.nodes(), 0.0);
        for (int k = 0; k < 3; ++k) {
            const auto& nodes = rig.solver(0).solid_nodes();
            force[2 * nodes[random() % nodes.size()] + random() % 2] += 1;
        }
        const PixelVector moved = rig.solver(0).solve_only(force);
        const double small = 1e-4;
        std::array<double, 2> norm{};
        for (const int way : {0, 1}) {
            PixelVector u = tested[0].displacement;
            for (std::size_t i = 0; i < u.size(); ++i)
                u[i] += (way == 0 ? -small : small) * moved[i];
            norm[std::size_t(way)] =
                failure_norm(std::vector<Tested>{rig.judged(rig.model(), u, 0)});
        }
        double foretold = 0;
        for (std::size_t i = 0; i < force.size(); ++i) foretold += force[i] * adjoint[0][i];
        const double change = (norm[1] - norm[0]) / (2 * small);
        EXPECT_NEAR(change, foretold, 1e-4 * std::abs(foretold) + 1e-7);
    }
}

TEST(Averaging, AndItsAdjointAreOneProduct) {
    const LoadCase part = beam_case();
    const TestRig rig = rig_of(part);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(0, 1);
    std::vector<double> a(rig.model().factor.size()), b(a.size());
    for (std::size_t p = 0; p < a.size(); ++p) {
        a[p] = rig.model().factor[p] > 0 ? number(random) : 0;
        b[p] = rig.model().factor[p] > 0 ? number(random) : 0;
    }
    const std::vector<double> mean = averaged_over_solid(rig.model(), a, 0.7),
                              back = averaging_adjoint(rig.model(), b, 0.7);
    double one = 0, other = 0;
    for (std::size_t p = 0; p < a.size(); ++p) {
        one += mean[p] * b[p];
        other += a[p] * back[p];
    }
    EXPECT_NEAR(one, other, 1e-11 * one);
}

}  // namespace
}  // namespace bead
