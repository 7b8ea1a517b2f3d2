#include "smooth/thinning.h"

#include <gtest/gtest.h>

#include "smooth/engine_block.h"
#include "smooth/sliced_section.h"
#include "support/layer_sums.h"
#include "support/regions.h"

namespace bead {
namespace {

TEST(Thinning, the_void_of_a_square_is_known) {
    // Its infill is one loop; the middle is farthest from it.
    const Toolpath layer = sliced_section(test::square(2 * (1.2 + 2.25 + 4)));
    EXPECT_NEAR(void_radius(layer, 0.05), 4, 0.05);
}

TEST(Thinning, half_of_the_engine_blocks_slotted_sections_loses_a_quarter_of_its_infill) {
    for (const int height : {25, 50}) {
        const Toolpath before = sliced_section(engine_block(height));
        const Toolpath after = thinned(before);
        EXPECT_LT(test::extruded(after, Role::infill),
                  0.775 * test::extruded(before, Role::infill));
    }
}

TEST(Thinning, volume_and_void_stay_and_nothing_but_infill_changes) {
    for (const int height : {15, 50}) {
        const Toolpath before = sliced_section(engine_block(height));
        const Toolpath after = thinned(before);
        EXPECT_NEAR(test::deposited(after), test::deposited(before), 1e-6);
        EXPECT_LE(void_radius(after, 0.25), 1.01 * void_radius(before, 0.25));
        EXPECT_LE(void_radius(after, 0.15), void_radius(before, 0.15) + 0.25);
        EXPECT_EQ(test::count(after, Role::wall), test::count(before, Role::wall));
        EXPECT_TRUE(test::is_connected(after));
    }
}

TEST(Thinning, a_larger_void_lets_more_loops_go) {
    const Toolpath before = sliced_section(engine_block(75));
    double last = test::extruded(before, Role::infill);
    for (const double radius : {4.5, 6.0}) {
        const double now = test::extruded(thinned(before, {.void_radius = radius}), Role::infill);
        EXPECT_LE(now, last + 1e-9);
        last = now;
    }
}

TEST(Thinning, no_bead_is_wider_or_faster_than_nozzle_and_hot_end_allow) {
    const Toolpath before = sliced_section(engine_block(50));
    for (const Path& path : thinned(before, {.void_radius = 9, .max_flow = 5})) {
        if (path.role != Role::infill) continue;
        EXPECT_LE(spacing(path.bead), 0.8 + 1e-9);
        EXPECT_LE(section(path.bead) * path.speed, 5 + 1e-9);
    }
}

TEST(Thinning, open_lines_are_left_alone) {
    Toolpath layer = sliced_section(test::square(40));
    for (Path& path : layer)
        if (path.role == Role::infill) path.points.pop_back();
    EXPECT_DOUBLE_EQ(test::extruded(thinned(layer), Role::infill),
                     test::extruded(layer, Role::infill));
}

TEST(Thinning, of_nothing_is_nothing) { EXPECT_TRUE(thinned({}).empty()); }

}  // namespace
}  // namespace bead
