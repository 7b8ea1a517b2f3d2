#include "geom/simplify.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/regions.h"

namespace bead {
namespace {

double straight_distance(const Polyline& line, Vec2 p) {
    double nearest = distance(line[0], p);
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec2 along = line[i] - line[i - 1];
        const double square = dot(along, along);
        const double t =
            square > 0 ? std::clamp(dot(p - line[i - 1], along) / square, 0.0, 1.0) : 0;
        nearest = std::min(nearest, distance(line[i - 1] + t * along, p));
    }
    return nearest;
}

Polyline random_walk(test::RandomRegions& random, int steps) {
    Polyline line{{}};
    for (int i = 0; i < steps; ++i) line.push_back(line.back() + random.point(1));
    return line;
}

TEST(Simplify, a_straight_line_needs_two_points) {
    EXPECT_EQ(simplified({{0, 0}, {1, 0}, {2, 0}, {5, 0}}, 1e-6).size(), 2U);
}

TEST(Simplify, a_fine_circle_keeps_its_area_within_the_tolerance) {
    const Region disc = test::disc({}, 20, 2000);
    const Region coarse = simplified(disc, 0.01);
    EXPECT_LT(coarse[0].outer.size(), 200U);
    EXPECT_NEAR(area(coarse), area(disc), 0.01 * perimeter(disc));
}

TEST(Simplify, a_loop_smaller_than_the_tolerance_vanishes) {
    EXPECT_TRUE(simplified(test::square(0.01), 1).empty());
}

RC_GTEST_PROP(Simplify, no_point_strays_farther_than_the_tolerance, (unsigned seed)) {
    test::RandomRegions random(seed);
    const Polyline line = random_walk(random, 300);
    const double tolerance = random.uniform(0.01, 3);
    const Polyline fewer = simplified(line, tolerance);
    RC_ASSERT(fewer.front() == line.front());
    RC_ASSERT(fewer.back() == line.back());
    for (const Vec2 p : line) RC_ASSERT(straight_distance(fewer, p) <= tolerance + 1e-12);
}

RC_GTEST_PROP(Simplify, what_is_kept_are_points_of_the_line_in_order, (unsigned seed)) {
    test::RandomRegions random(seed);
    const Polyline line = random_walk(random, 200);
    auto from = line.begin();
    for (const Vec2 p : simplified(line, random.uniform(0.01, 3))) {
        from = std::find(from, line.end(), p);
        RC_ASSERT(from != line.end());
    }
}

}  // namespace
}  // namespace bead
