#include "geom/curvature_limit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "support/regions.h"

namespace bead {
namespace {

TEST(CurvatureLimit, at_60_mm_per_s_acceleration_decides) {
    const CurvatureBounds bounds = curvature_bounds({}, 60);
    EXPECT_NEAR(bounds.chord, 20, 0.005);
    EXPECT_NEAR(bounds.acceleration, 0.278, 0.0005);
    EXPECT_NEAR(bounds.jerk, 0.304, 0.0005);
    EXPECT_EQ(bounds.nozzle, 5);
    EXPECT_EQ(largest_curvature({}, 60), bounds.acceleration);
}

TEST(CurvatureLimit, least_radii_are_those_of_the_table) {
    for (const auto& [speed, radius] :
         {std::pair{60.0, 3.6}, {50.0, 2.5}, {100.0, 10.0}, {150.0, 22.5}})
        EXPECT_NEAR(1 / largest_curvature({}, speed), radius, 1e-9) << speed;
}

TEST(CurvatureLimit, a_straight_line_has_none) {
    EXPECT_EQ(feed_limit({}, 0), std::numeric_limits<double>::infinity());
    EXPECT_NEAR(feed_limit({}, 0, 0.02), 100, 1e-9);  // jerk 2e4 at 0.02 per mm²
}

// Run as fast as the curvature allows, the curvature is what the speed allows.
RC_GTEST_PROP(CurvatureLimit, curvature_and_feed_undo_each_other, (unsigned seed)) {
    test::RandomRegions random(seed);
    const CurvatureLimits limits{std::exp(random.uniform(4, 10)), std::exp(random.uniform(7, 14)),
                                 random.uniform(0.001, 0.05), random.uniform(1e-4, 0.02), 1e-9};
    const double speed = random.uniform(1, 300);
    const double bend = largest_curvature(limits, speed);
    RC_ASSERT(std::abs(feed_limit(limits, bend) / speed - 1) < 1e-6);
    // A circle of less than the chord error across is not limited by it.
    RC_PRE(1.1 * bend * limits.chord_error < 2);
    RC_ASSERT(feed_limit(limits, -1.1 * bend) < speed);
    RC_ASSERT(feed_limit(limits, bend, 1e3) <= feed_limit(limits, bend));
}

}  // namespace
}  // namespace bead
