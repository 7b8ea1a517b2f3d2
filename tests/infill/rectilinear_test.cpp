#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "infill/fill.h"
#include "support/regions.h"

namespace bead {
namespace {

using test::RandomRegions;

TEST(Rectilinear, fills_a_small_square_by_hand) {
    const auto lines = rectilinear(test::rectangle({0, 0.5}, {10, 3.5}), {.spacing = 1});
    ASSERT_EQ(lines.size(), 1U);
    Polyline line = lines[0];
    if (line.front().y > line.back().y) std::reverse(line.begin(), line.end());
    const bool from_left = line.front().x < 5;
    const double a = from_left ? 0 : 10, b = 10 - a;
    const Polyline expected{{a, 1}, {b, 1}, {b, 2}, {a, 2}, {a, 3}, {b, 3}};
    ASSERT_EQ(line.size(), expected.size());
    for (std::size_t i = 0; i < line.size(); ++i)
        EXPECT_LT(distance(line[i], expected[i]), 1e-12) << i;
}

TEST(Rectilinear, counts_lines_from_the_centre) {
    const auto lines = rectilinear(test::rectangle({-5, -0.1}, {5, 0.1}), {.spacing = 3});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NEAR(lines[0][0].y, 0, 1e-12);
    EXPECT_TRUE(
        rectilinear(test::rectangle({-5, -0.1}, {5, 0.1}), {.spacing = 3, .centre = {0, 1.5}})
            .empty());
}

RC_GTEST_PROP(Rectilinear, is_one_line_in_a_convex_region, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.convex(random.point(20), random.uniform(5, 40));
    const auto lines =
        rectilinear(region, {.spacing = random.uniform(0.4, 2), .angle = random.uniform(0, 7)});
    RC_ASSERT(lines.size() <= 1U);
    RC_ASSERT(lines.size() == 1U || area(region) < 100);
}

RC_GTEST_PROP(Rectilinear, half_a_turn_gives_the_same_lines, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    FillOptions options{
        .spacing = random.uniform(0.4, 4), .angle = random.uniform(0, 7), .link = 0};
    const auto middles = [&] {
        std::vector<Vec2> points;
        for (const Polyline& line : rectilinear(region, options))
            points.push_back(lerp(line.front(), line.back(), 0.5));
        return points;
    };
    const auto before = middles();
    options.angle += pi;
    const auto after = middles();
    RC_ASSERT(before.size() == after.size());
    for (const Vec2 p : before)
        RC_ASSERT(
            std::any_of(after.begin(), after.end(), [&](Vec2 q) { return distance(p, q) < 1e-6; }));
}

// A hole parts the lines beside it, and the way round it is not walked twice: at most two lines
// more for each.
RC_GTEST_PROP(Rectilinear, holes_cost_at_most_two_lines_each, (unsigned seed)) {
    RandomRegions random(seed);
    Region region = test::disc({}, 50, 200);
    const int holes = random.whole(0, 8);
    for (int i = 0; i < holes; ++i)
        region = difference(region, test::disc(35.0 * unit(2 * pi * i / 8), random.uniform(2, 10)));
    const auto lines =
        rectilinear(region, {.spacing = random.uniform(0.4, 1), .angle = random.uniform(0, 7)});
    RC_ASSERT(lines.size() <= 1 + 2 * static_cast<std::size_t>(holes));
}

}  // namespace
}  // namespace bead
