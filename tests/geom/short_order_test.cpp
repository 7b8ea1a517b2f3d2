#include "geom/short_order.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

#include "geom/near_order.h"

namespace bead {
namespace {

Vec2 any_place() { return {0.1 * *rc::gen::inRange(0, 1000), 0.1 * *rc::gen::inRange(0, 1000)}; }

// The line, from whichever end comes first.
Polyline from_lower_end(Polyline line) {
    const auto key = [](Vec2 p) { return std::pair(p.x, p.y); };
    if (key(line.back()) < key(line.front())) std::ranges::reverse(line);
    return line;
}

RC_GTEST_PROP(ShortOrder, KeepsTheLinesAndIsNoLongerThanTheNearest, ()) {
    std::vector<Polyline> lines;
    const int count = *rc::gen::inRange(1, 40);
    for (int i = 0; i < count; ++i) lines.push_back({any_place(), any_place(), any_place()});
    const Vec2 start = any_place();
    const std::vector<Polyline> order = short_order(lines, start);
    RC_ASSERT(travel_between(order, start) <=
              travel_between(near_order(lines, start), start) + 1e-9);
    const auto sorted = [](std::vector<Polyline> all) {
        for (Polyline& line : all) line = from_lower_end(line);
        std::ranges::sort(all, [](const Polyline& a, const Polyline& b) {
            return std::pair(a[0].x, a[0].y) < std::pair(b[0].x, b[0].y);
        });
        return all;
    };
    const auto before = sorted(lines), after = sorted(order);
    RC_ASSERT(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) RC_ASSERT(before[i].size() == after[i].size());
}

// The nearest next leaves lines behind and must come back for them; turns mend some of that.
TEST(ShortOrder, TakesBackWhatTheNearestLeavesBehind) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, 100);
    const auto any = [&] { return Vec2{place(random), place(random)}; };
    std::vector<Polyline> lines;
    for (int i = 0; i < 60; ++i) {
        const Vec2 from = any();
        lines.push_back({from, from + Vec2{0, 0.1}});
    }
    EXPECT_LT(travel_between(short_order(lines, {}), {}),
              0.95 * travel_between(near_order(lines, {}), {}));
}

TEST(ShortOrder, OfNothingIsNothing) { EXPECT_TRUE(short_order({}, {0, 0}).empty()); }

}  // namespace
}  // namespace bead
