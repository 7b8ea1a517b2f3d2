#include "smooth/bead_plan.h"

#include <gtest/gtest.h>

#include "smooth/engine_block.h"
#include "smooth/sliced_section.h"
#include "support/layer_sums.h"
#include "support/regions.h"

namespace bead {
namespace {

TEST(BeadPlan, two_inner_loops_become_one_that_deposits_the_volume_of_both) {
    const Toolpath before = sliced_section(test::square(30));
    const Toolpath after = bead_planned(before);
    EXPECT_EQ(test::count(before, Role::wall), 2U);
    EXPECT_EQ(test::count(after, Role::wall), 1U);
    EXPECT_NEAR(test::deposited(after, Role::wall), test::deposited(before, Role::wall), 1e-9);
    EXPECT_NEAR(test::extruded(after, Role::wall), 4 * (30 - 1.6), 1e-6);
}

TEST(BeadPlan, outer_walls_and_infill_are_left_alone) {
    for (const int height : engine_block_heights) {
        const Toolpath before = sliced_section(engine_block(height));
        const Toolpath after = bead_planned(before);
        for (const Role role : {Role::outer_wall, Role::infill}) {
            EXPECT_EQ(test::count(after, role), test::count(before, role));
            EXPECT_NEAR(test::extruded(after, role), test::extruded(before, role), 1e-9);
        }
        EXPECT_NEAR(test::deposited(after), test::deposited(before), 1e-6);
    }
}

TEST(BeadPlan, every_wall_of_the_engine_block_has_its_inner_loops_merged) {
    for (const int height : engine_block_heights) {
        const Toolpath before = sliced_section(engine_block(height));
        EXPECT_EQ(test::count(bead_planned(before), Role::wall),
                  test::count(before, Role::outer_wall));
    }
}

TEST(BeadPlan, no_bead_is_wider_or_faster_than_nozzle_and_hot_end_allow) {
    const Toolpath before = sliced_section(engine_block(50));
    EXPECT_TRUE(test::is_same(bead_planned(before, {.nozzle = 0.3}), before));
    EXPECT_TRUE(test::is_same(bead_planned(before, {.max_flow = 3}), before));
    for (const Path& path : bead_planned(before, {.max_flow = 5})) {
        if (path.role != Role::wall) continue;
        EXPECT_LE(section(path.bead) * path.speed, 5 + 1e-9);
    }
}

TEST(BeadPlan, whatever_the_outline_the_volume_stays) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        const Toolpath before = sliced_section(test::RandomRegions(seed).any());
        const Toolpath after = bead_planned(before);
        EXPECT_NEAR(test::deposited(after), test::deposited(before),
                    1e-9 * test::deposited(before));
        EXPECT_TRUE(test::is_connected(after));
    }
}

TEST(BeadPlan, of_nothing_is_nothing) { EXPECT_TRUE(bead_planned({}).empty()); }

}  // namespace
}  // namespace bead
