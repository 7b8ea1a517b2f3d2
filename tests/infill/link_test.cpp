#include "infill/link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/regions.h"

namespace bead {
namespace {

const std::vector<MeasuredLoop> link_square = measured_loops(test::rectangle({0, 0}, {10, 10}));

// Across the square, 1 mm apart.
std::vector<CutLine> rungs(int count) {
    std::vector<CutLine> lines;
    for (int i = 1; i <= count; ++i)
        lines.push_back({{{0, 1.0 * i}, {10, 1.0 * i}}, {0, 40.0 - i}, {0, 10.0 + i}});
    return lines;
}

TEST(Link, joins_a_ladder_into_one_line_wherever_it_begins) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        std::vector<CutLine> lines = rungs(9);
        std::shuffle(lines.begin(), lines.end(), std::mt19937(seed));
        const auto paths = linked(lines, link_square, 2);
        ASSERT_EQ(paths.size(), 1U);
        EXPECT_NEAR(length(paths[0]), 9 * 10 + 8 * 1, 1e-9);
    }
}

TEST(Link, takes_no_way_that_is_too_long) {
    EXPECT_EQ(linked(rungs(9), link_square, 0.999).size(), 9U);
    EXPECT_EQ(linked(rungs(9), link_square, 1.001).size(), 1U);
}

TEST(Link, follows_the_corners_of_the_edge) {
    const std::vector<CutLine> lines{{{{0, 5}, {5, 5}}, {0, 35}, {}},
                                     {{{5, 0}, {5, 4}}, {0, 5}, {}}};
    const auto paths = linked(lines, link_square, 1e9);
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_NEAR(length(paths[0]), 5 + 10 + 4, 1e-9);
    EXPECT_NE(std::find(paths[0].begin(), paths[0].end(), Vec2{}), paths[0].end());
}

TEST(Link, leaves_lines_that_end_inside_alone) {
    const std::vector<CutLine> lines{{{{1, 1}, {2, 1}}, {}, {}}, {{{1, 2}, {2, 2}}, {}, {}}};
    EXPECT_EQ(linked(lines, link_square, 1e9).size(), 2U);
}

TEST(Link, does_not_close_a_line_on_itself) {
    const auto paths = linked(rungs(1), link_square, 1e9);
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_NEAR(length(paths[0]), 10, 1e-9);
}

}  // namespace
}  // namespace bead
