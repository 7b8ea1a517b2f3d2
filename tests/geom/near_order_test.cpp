#include "geom/near_order.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "support/regions.h"

namespace bead {
namespace {

std::vector<Polyline> random_lines(test::RandomRegions& random, int count) {
    std::vector<Polyline> lines;
    for (int i = 0; i < count; ++i) {
        const Vec2 start = random.point(50);
        lines.push_back({start, start + random.point(5), start + random.point(10)});
    }
    return lines;
}

// The same by looking at every line that is left.
std::vector<Polyline> slow_order(std::vector<Polyline> lines, Vec2 at) {
    std::vector<Polyline> ordered;
    while (!lines.empty()) {
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double off =
                std::min(distance(lines[i].front(), at), distance(lines[i].back(), at));
            if (off < least) {
                least = off;
                best = i;
            }
        }
        Polyline line = lines[best];
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(best));
        if (distance(line.back(), at) < distance(line.front(), at))
            std::reverse(line.begin(), line.end());
        at = line.back();
        ordered.push_back(line);
    }
    return ordered;
}

TEST(NearOrder, nothing_stays_nothing) { EXPECT_TRUE(near_order({}, {}).empty()); }

TEST(NearOrder, lines_at_one_point_are_all_kept) {
    const std::vector<Polyline> lines(7, Polyline{{1, 1}, {2, 2}, {1, 1}});
    EXPECT_EQ(near_order(lines, {}), lines);
}

RC_GTEST_PROP(NearOrder, is_the_order_of_the_slow_search, (unsigned seed)) {
    test::RandomRegions random(seed);
    const std::vector<Polyline> lines = random_lines(random, random.whole(1, 200));
    const Vec2 start = random.point(100);
    RC_ASSERT(near_order(lines, start) == slow_order(lines, start));
}

}  // namespace
}  // namespace bead
