#include "geom/polygon.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/regions.h"
#include "support/winding.h"

namespace bead {
namespace {

using test::RandomRegions;

TEST(Polygon, a_regular_one_measures_as_geometry_says) {
    const Polyline loop = test::regular({3, 4}, 5, 12);
    EXPECT_NEAR(signed_area(loop), 12 * 25 * std::sin(2 * pi / 12) / 2, 1e-12);
    EXPECT_NEAR(loop_length(loop), 12 * 2 * 5 * std::sin(pi / 12), 1e-12);
    EXPECT_NEAR(length(loop), 11 * 2 * 5 * std::sin(pi / 12), 1e-12);
}

TEST(Polygon, nothing_measures_nothing) {
    EXPECT_EQ(area(Region{}), 0);
    EXPECT_EQ(perimeter({}), 0);
    EXPECT_TRUE(bounds(Region{}).is_empty());
    EXPECT_FALSE(contains({}, {}));
    EXPECT_TRUE(std::isinf(boundary_distance({}, {})));
}

TEST(Polygon, a_hole_is_outside) {
    const Region ring = test::ring(10, 5);
    EXPECT_TRUE(contains(ring, {7, 0}));
    EXPECT_FALSE(contains(ring, {0, 0}));
    EXPECT_NEAR(boundary_distance(ring, {0, 0}), 5 * std::cos(pi / 64), 1e-5);
}

RC_GTEST_PROP(Polygon, inside_is_where_the_loops_wind_round, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    for (int i = 0; i < 50; ++i) {
        const Vec2 p = random.point(60);
        if (boundary_distance(region, p) > 1e-6)
            RC_ASSERT(contains(region, p) == test::wound(region, p));
    }
}

RC_GTEST_PROP(Polygon, turning_and_moving_change_no_measure, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    const double angle = random.uniform(-7, 7);
    const Vec2 about = random.point(50), shift = random.point(50);
    const Region there = moved(region, angle, about, shift);
    RC_ASSERT(std::abs(area(there) - area(region)) < 1e-8);
    RC_ASSERT(std::abs(perimeter(there) - perimeter(region)) < 1e-8);
    const Region back = moved(there, -angle, about + shift, -shift);
    for (std::size_t i = 0; i < region.size(); ++i)
        for (std::size_t k = 0; k < region[i].outer.size(); ++k)
            RC_ASSERT(distance(back[i].outer[k], region[i].outer[k]) < 1e-10);
}

RC_GTEST_PROP(Polygon, no_boundary_point_is_nearer_than_the_boundary_distance, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    const Vec2 p = random.point(60);
    const double nearest = boundary_distance(region, p);
    double sampled = 1e9;
    for (const Polygon& polygon : region)
        for (std::size_t i = 0; i < polygon.outer.size(); ++i)
            for (double t = 0; t < 1; t += 0.05)
                sampled = std::min(
                    sampled, distance(p, lerp(polygon.outer[i],
                                              polygon.outer[(i + 1) % polygon.outer.size()], t)));
    RC_ASSERT(nearest <= sampled + 1e-12);
}

RC_GTEST_PROP(Polygon, bounds_hold_every_corner_tightly, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    const Box2 box = bounds(region);
    Box2 corners;
    for (const Polygon& polygon : region)
        for (const Vec2 p : polygon.outer) corners.include(p);
    RC_ASSERT(box.low == corners.low);
    RC_ASSERT(box.high == corners.high);
}

}  // namespace
}  // namespace bead
