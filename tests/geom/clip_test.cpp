#include "geom/clip.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/regions.h"

namespace bead {
namespace {

using test::RandomRegions;

// Coordinates are rounded to 1 nm, so areas are off by about that times the outline's length.
double rounding(const Region& a, const Region& b) { return 1e-5 * (perimeter(a) + perimeter(b)); }

double summed_length(const std::vector<Polyline>& lines) {
    double sum = 0;
    for (const Polyline& line : lines) sum += length(line);
    return sum;
}

TEST(Clip, an_offset_square_is_a_square) {
    EXPECT_NEAR(area(offset(test::square(10), 1)), 144, 1e-6);
    EXPECT_NEAR(area(offset(test::square(10), -1)), 64, 1e-6);
    EXPECT_TRUE(offset(test::square(10), -5.001).empty());
}

TEST(Clip, a_round_offset_adds_what_steiner_says) {
    const double grown = area(offset(test::square(10), 2, Corner::round));
    EXPECT_NEAR(grown, 100 + 40 * 2 + pi * 4, 0.02);
}

TEST(Clip, winding_rules_differ_on_loops_that_overlap) {
    const std::vector<Polyline> loops{test::square(10)[0].outer, test::square(4)[0].outer};
    EXPECT_NEAR(area(region_of(loops, FillRule::even_odd)), 100 - 16, 1e-6);
    EXPECT_NEAR(area(region_of(loops, FillRule::positive)), 100, 1e-6);
}

TEST(Clip, opening_removes_what_is_narrow) {
    const Region bar = united(test::square(10), test::rectangle({0, -0.2}, {20, 0.2}));
    EXPECT_NEAR(area(opened(bar, 0.5)), 100, 0.1);
    EXPECT_NEAR(area(opened(bar, 0.1)), area(bar), 0.1);
}

RC_GTEST_PROP(Clip, areas_obey_inclusion_and_exclusion, (unsigned seed)) {
    RandomRegions random(seed);
    const Region a = random.any(), b = random.any();
    const double both = area(intersection(a, b)), slack = rounding(a, b);
    RC_ASSERT(std::abs(area(united(a, b)) + both - area(a) - area(b)) < slack);
    RC_ASSERT(std::abs(area(difference(a, b)) + both - area(a)) < slack);
    RC_ASSERT(both >= 0);
    RC_ASSERT(both <= std::min(area(a), area(b)) + slack);
}

RC_GTEST_PROP(Clip, sums_and_differences_are_clean, (unsigned seed)) {
    RandomRegions random(seed);
    for (const Polygon& polygon : difference(random.any(), random.any())) {
        RC_ASSERT(signed_area(polygon.outer) > 0);
        double holes = 0;
        for (const Polyline& hole : polygon.holes) {
            RC_ASSERT(signed_area(hole) < 0);
            holes -= signed_area(hole);
        }
        RC_ASSERT(holes < signed_area(polygon.outer));
    }
}

RC_GTEST_PROP(Clip, area_grows_with_the_offset, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    double before = -1;
    for (double distance = -3; distance <= 3; distance += 0.5) {
        const double now = area(offset(region, distance));
        RC_ASSERT(now >= before - rounding(region, region));
        before = now;
    }
}

RC_GTEST_PROP(Clip, an_inset_keeps_its_distance, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.star_with_holes({}, 30);
    const double distance = random.uniform(0.1, 3);
    for (const Polygon& polygon : offset(region, -distance))
        for (const Vec2 p : polygon.outer) {
            RC_ASSERT(contains(region, p));
            RC_ASSERT(boundary_distance(region, p) > distance - 1e-4);
        }
}

RC_GTEST_PROP(Clip, parts_inside_and_outside_make_up_the_line, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    std::vector<Polyline> lines(20);
    for (Polyline& line : lines) line = {random.point(60), random.point(60), random.point(60)};
    const double parts =
        summed_length(inside_parts(lines, region)) + summed_length(outside_parts(lines, region));
    RC_ASSERT(std::abs(parts - summed_length(lines)) < 1e-3);
}

}  // namespace
}  // namespace bead
