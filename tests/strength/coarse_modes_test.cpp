#include "strength/coarse_modes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bead {
namespace {

// A displacement that is linear in the place comes over exactly wherever there are solid nodes
// around, holes or not.
TEST(CoarseModes, keep_a_constant_and_in_the_solid_a_linear_shape) {
    PixelModel coarse;
    coarse.grid = {{0, 0}, 0.3, 20, 10};
    coarse.factor.assign(coarse.grid.pixels(), 1.0);
    for (int j = 3; j < 7; ++j)
        for (int i = 5; i < 9; ++i) coarse.factor[coarse.grid.pixel(i, j)] = 0;
    PixelVector shape(2 * coarse.grid.nodes());
    for (std::size_t node = 0; node < coarse.grid.nodes(); ++node) {
        const Vec2 p = coarse.grid.place(node);
        shape[2 * node] = 2 * p.x - p.y + 1;
        shape[2 * node + 1] = 7;
    }
    const PixelGrid fine{{0, 0}, 0.1, 60, 30};
    const PixelVector moved = transferred(coarse, shape, fine);
    for (std::size_t node = 0; node < fine.nodes(); ++node) {
        const Vec2 p = fine.place(node);
        const bool deep_in_hole = p.x > 1.75 && p.x < 2.45 && p.y > 1.15 && p.y < 1.85;
        const bool near_hole = p.x > 1.4 && p.x < 2.8 && p.y > 0.8 && p.y < 2.2;
        if (deep_in_hole) {
            EXPECT_TRUE(moved[2 * node + 1] == 0 || std::abs(moved[2 * node + 1] - 7) < 1e-9);
            continue;
        }
        if (near_hole) continue;
        EXPECT_NEAR(moved[2 * node], 2 * p.x - p.y + 1, 1e-9);
        EXPECT_NEAR(moved[2 * node + 1], 7, 1e-9);
    }
}

}  // namespace
}  // namespace bead
