#include "infill/clear_of_walls.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace bead {
namespace {

const std::vector<Polyline> wall{{{0, 0}, {100, 0}}};

double whole(const std::vector<FamilyLine>& lines) {
    double sum = 0;
    for (const FamilyLine& line : lines) sum += length(line.points);
    return sum;
}

TEST(ClearOfWalls, ALineOnAWallIsLeftOut) {
    EXPECT_LT(whole(clear_of_walls({{0, {{10, 0.2}, {50, 0.2}}}}, wall, {})), 1e-9);
    EXPECT_NEAR(length_along_walls({{0, {{10, 0.2}, {50, 0.2}}}}, wall, {}), 40, 0.2);
}

TEST(ClearOfWalls, ALineThatEndsOnAWallOrCrossesItStays) {
    const std::vector<FamilyLine> lines{{0, {{10, 8}, {12, 0}}}, {1, {{20, 8}, {24, -8}}}};
    const std::vector<FamilyLine> kept = clear_of_walls(lines, wall, {});
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept[0].points, lines[0].points);
    EXPECT_EQ(kept[1].points, lines[1].points);
}

// Comes down to the wall, runs along it, leaves it: both joints stay, what lies between does not.
TEST(ClearOfWalls, JointsStay) {
    const std::vector<FamilyLine> kept =
        clear_of_walls({{1, {{10, 10}, {20, 0.1}, {60, 0.1}, {70, 10}}}}, wall, {});
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_LT(kept[0].points.back().y, 0.35);
    EXPECT_LT(kept[1].points.front().y, 0.35);
    EXPECT_LT(kept[0].points.back().x, 20.2);
    EXPECT_GT(kept[1].points.front().x, 59.8);
    EXPECT_EQ(kept[0].family, 1);
}

TEST(ClearOfWalls, WithoutWallsNothingIsCut) {
    EXPECT_EQ(clear_of_walls({{0, {{0, 0}, {9, 0}}}}, {}, {}).size(), 1u);
}

// Nothing is added, nothing runs along a wall any more, and doing it again changes nothing.
RC_GTEST_PROP(ClearOfWalls, LeavesNothingOnTheWall, ()) {
    Polyline line;
    double height = 0.05 * *rc::gen::inRange(0, 60);
    for (int i = 0; i < 60; ++i) {
        line.push_back({20 + double(i), height});
        height = std::max(0.0, height + 0.05 * *rc::gen::inRange(-10, 11));
    }
    const std::vector<FamilyLine> before{{0, line}};
    const std::vector<FamilyLine> after = clear_of_walls(before, wall, {});
    RC_ASSERT(whole(after) <= whole(before) + 1e-9);
    RC_ASSERT(length_along_walls(after, wall, {}) <= length_along_walls(before, wall, {}) + 1e-9);
    for (const FamilyLine& piece : after)
        for (const Vec2 p : piece.points) RC_ASSERT(p.y >= -1e-9);
}

}  // namespace
}  // namespace bead
