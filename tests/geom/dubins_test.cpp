#include "geom/dubins.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/arc.h"
#include "geom/deviation.h"
#include "support/regions.h"

namespace bead {
namespace {

Pose any_pose(test::RandomRegions& random) { return {random.point(20), random.uniform(-7, 7)}; }
Pose backwards(const Pose& pose) { return {pose.at, pose.heading + pi}; }

TEST(Dubins, straight_on_is_straight) {
    const DubinsPath path = dubins({{0, 0}, 0.3}, {5 * unit(0.3), 0.3}, 2);
    EXPECT_NEAR(length(path), 5, 1e-9);
    EXPECT_NEAR(path.first, 0, 1e-9);
    EXPECT_NEAR(path.last, 0, 1e-9);
}

TEST(Dubins, half_a_turn_is_half_a_circle) {
    const DubinsPath path = dubins({{0, 0}, 0}, {{0, 4}, pi}, 2);
    EXPECT_NEAR(length(path), 2 * pi, 1e-9);
    EXPECT_LT(distance(pose_at(path, pi).at, {2, 2}), 1e-9);
}

TEST(Dubins, a_lane_change_is_an_s) {
    const DubinsPath path = dubins({{0, 0}, 0}, {{20, 4}, 0}, 2);
    EXPECT_GT(path.first, 0);
    EXPECT_NEAR(path.first, -path.last, 1e-12);
    EXPECT_LT(length(path), 21);
}

TEST(Dubins, staying_is_no_way_at_all) {
    EXPECT_NEAR(length(dubins({{3, 4}, 1}, {{3, 4}, 1}, 2)), 0, 1e-8);
}

RC_GTEST_PROP(Dubins, ends_where_and_how_it_should, (unsigned seed)) {
    test::RandomRegions random(seed);
    const Pose from = any_pose(random), to = any_pose(random);
    const DubinsPath path = dubins(from, to, random.uniform(0.1, 10));
    const Pose end = pose_at(path, length(path));
    RC_ASSERT(distance(end.at, to.at) < 1e-7);
    RC_ASSERT(distance(unit(end.heading), unit(to.heading)) < 1e-8);
    RC_ASSERT(length(path) > distance(from.at, to.at) - 1e-9);
    RC_ASSERT(std::abs(length(dubins(backwards(to), backwards(from), path.radius)) - length(path)) <
              1e-6);
}

// Steps of the same length along it: neighbours lie that far apart, and triples on a circle of the
// radius or on a wider one.
RC_GTEST_PROP(Dubins, never_turns_more_tightly_than_the_radius, (unsigned seed)) {
    test::RandomRegions random(seed);
    const DubinsPath path = dubins(any_pose(random), any_pose(random), random.uniform(0.1, 10));
    const double step = 0.05 * path.radius;
    RC_PRE(length(path) < 1000 * step);
    std::vector<Vec2> points;
    for (double along = 0; along < length(path); along += step)
        points.push_back(pose_at(path, along).at);
    for (std::size_t i = 1; i < points.size(); ++i) {
        RC_ASSERT(distance(points[i - 1], points[i]) < step + 1e-9);
        if (i > 1)
            RC_ASSERT(circumradius(points[i - 2], points[i - 1], points[i]) >
                      path.radius * (1 - 1e-6));
    }
    const double tolerance = 0.01 * path.radius;
    RC_ASSERT(deviation(points, flattened(path, tolerance), 1) < 1.001 * tolerance + 1e-9);
}

RC_GTEST_PROP(Dubins, is_at_most_two_circles_longer_than_the_line, (unsigned seed)) {
    test::RandomRegions random(seed);
    const Pose from = any_pose(random), to = any_pose(random);
    const double radius = random.uniform(0.1, 10);
    RC_ASSERT(length(dubins(from, to, radius)) < distance(from.at, to.at) + (2 + 4 * pi) * radius);
}

}  // namespace
}  // namespace bead
