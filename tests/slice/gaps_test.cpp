#include "slice/gaps.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "support/shapes.h"

namespace bead {
namespace {

RC_GTEST_PROP(gaps, an_outline_cut_in_pieces_is_whole_again, (std::uint64_t seed)) {
    const Polyline outline = shapes::random_star(seed, 40, 10, 12);
    std::vector<Polyline> pieces;
    for (std::size_t i = 0; i < 40; i += 4)
        pieces.push_back({outline[i], outline[i + 1], outline[i + 2], outline[i + 3],
                          lerp(outline[i + 3], outline[(i + 4) % 40], 0.99)});
    std::mt19937_64 random(seed);
    std::ranges::shuffle(pieces, random);
    const Joined result = joined(pieces, 2);
    RC_ASSERT(result.open.empty());
    RC_ASSERT(result.loops.size() == 1);
    RC_ASSERT(std::abs(signed_area(result.loops[0]) / signed_area(outline) - 1) < 1e-9);
}

RC_GTEST_PROP(gaps, no_point_is_lost_or_made, (std::uint64_t seed)) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(0, 10);
    std::vector<Polyline> lines(20);
    for (Polyline& line : lines)
        for (int i = 0; i < 3; ++i) line.push_back({place(random), place(random)});
    const Joined result = joined(lines, 2);
    std::size_t points = 0;
    for (const auto& group : {result.loops, result.open})
        for (const Polyline& line : group) points += line.size();
    RC_ASSERT(points == 60);
}

TEST(gaps, the_nearest_partner_wins) {
    const std::vector<Polyline> lines{
        {{0, 0}, {10, 0}}, {{11, 0}, {20, 0}}, {{10.5, 0}, {10.5, 9}}};
    const Joined result = joined(lines, 2);
    ASSERT_EQ(result.open.size(), 2U);
    EXPECT_EQ(result.open[0], (Polyline{{0, 0}, {10, 0}, {10.5, 0}, {10.5, 9}}));
}

TEST(gaps, a_scrap_does_not_close_on_itself) {
    EXPECT_EQ(joined({{{0, 0}, {1, 0}}}, 2).open.size(), 1U);
    EXPECT_EQ(joined({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, 2).loops.size(), 1U);
}

TEST(gaps, starts_do_not_meet_starts) {
    EXPECT_EQ(joined({{{0, 0}, {9, 0}}, {{0, 0.1}, {0, 9}}}, 2).open.size(), 2U);
}

}  // namespace
}  // namespace bead
