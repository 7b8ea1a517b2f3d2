#include "geom/along.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/regions.h"

namespace bead {
namespace {

TEST(Along, places_on_a_square_count_round_its_sides) {
    const MeasuredLoop loop = measured({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    EXPECT_EQ(loop.length, 40);
    EXPECT_EQ(point_at(loop, 15), (Vec2{10, 5}));
    EXPECT_EQ(point_at(loop, 35), (Vec2{0, 5}));
    EXPECT_EQ(point_at(loop, -5), (Vec2{0, 5}));
    EXPECT_EQ(point_at(loop, 40), (Vec2{0, 0}));
    EXPECT_EQ(way(loop, 5, 25), (Polyline{{10, 0}, {10, 10}}));
    EXPECT_EQ(way(loop, 35, 15), (Polyline{{0, 0}, {10, 0}}));
    EXPECT_EQ(way(loop, 10, 20), Polyline{});
}

RC_GTEST_PROP(Along, a_way_is_as_long_as_its_places_say, (unsigned seed)) {
    test::RandomRegions random(seed);
    for (const MeasuredLoop& loop : measured_loops(random.any())) {
        const double from = random.uniform(0, loop.length), to = random.uniform(0, loop.length);
        Polyline line = way(loop, from, to);
        line.insert(line.begin(), point_at(loop, from));
        line.push_back(point_at(loop, to));
        const double expected = to >= from ? to - from : to - from + loop.length;
        RC_ASSERT(std::abs(length(line) - expected) < 1e-9);
    }
}

}  // namespace
}  // namespace bead
