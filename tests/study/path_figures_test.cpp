#include "study/path_figures.h"

#include <gtest/gtest.h>

namespace bead {
namespace {

const Region plate{{{{0, 0}, {40, 0}, {40, 30}, {0, 30}}, {}}};

Path loop(double inset, double width) {
    const double a = inset, x = 40 - inset, y = 30 - inset;
    return {.role = Role::wall,
            .bead = {width, 0.2},
            .speed = 50,
            .points = {{a, a, 0}, {x, a, 0}, {x, y, 0}, {a, y, 0}, {a, a, 0}}};
}

double figure(const std::vector<Figure>& figures, const std::string& name) {
    for (const Figure& f : figures)
        if (f.name == name) return f.value;
    ADD_FAILURE() << name;
    return 0;
}

TEST(Coverage, OfWallsSideBySideIsWhole) {
    const Coverage c = coverage({loop(0.2, 0.4), loop(0.6, 0.4), loop(1.0, 0.4)}, plate, 1.2, 0.05);
    EXPECT_LT(c.under, 1);  // four rounded corners
    EXPECT_LT(c.over, 1);
    EXPECT_LT(c.outside, 0.5);
}

TEST(Coverage, MissesTheLoopThatIsLeftOutAndCountsTheOneLaidTwice) {
    const double middle = 2 * (40 - 1.2) + 2 * (30 - 1.2);
    const Coverage gap = coverage({loop(0.2, 0.4), loop(1.0, 0.4)}, plate, 1.2, 0.05);
    EXPECT_NEAR(gap.under, 0.4 * middle, 1.5);
    const Coverage twice = coverage(
        {loop(0.2, 0.4), loop(0.6, 0.4), loop(0.6, 0.4), loop(1.0, 0.4)}, plate, 1.2, 0.05);
    EXPECT_NEAR(twice.over, 0.4 * middle, 1.5);
    const Coverage out = coverage({loop(0, 0.4)}, plate, 0.2, 0.05);
    EXPECT_NEAR(out.outside, 0.2 * 2 * (40 + 30), 1);
}

TEST(PathFigures, CountLengthsPointsAndTurns) {
    Path travel{
        .role = Role::travel, .bead = {}, .speed = 120, .points = {{0.2, 0.2, 0}, {1, 1, 0}}};
    Path infill{
        .role = Role::infill, .bead = {0.4, 0.2}, .speed = 60, .points = {{1, 1, 0}, {39, 1, 0}}};
    const auto f = path_figures({loop(0.2, 0.4), travel, infill});
    const double around = 2 * 39.6 + 2 * 29.6, hop = std::hypot(0.8, 0.8);
    EXPECT_NEAR(figure(f, "length, mm"), around + hop + 38, 1e-9);
    EXPECT_NEAR(figure(f, "travel, mm"), hop, 1e-9);
    EXPECT_NEAR(figure(f, "infill with travel, mm"), 38 + hop, 1e-9);
    EXPECT_EQ(figure(f, "points"), 7);
    EXPECT_EQ(figure(f, "turns 45°"), 4);  // three corners, the travel's start; its end turns by 45
    EXPECT_EQ(figure(f, "windowed turns"), 4);
}

TEST(PathFigures, ChordErrorOfAPolygonIsItsSagitta) {
    const double radius = 17, n = 75;
    Path ring{.role = Role::wall, .bead = {0.4, 0.2}, .speed = 50, .points = {}};
    for (int i = 0; i <= 75; ++i) {
        const Vec2 at = radius * unit(2 * pi * i / n);
        ring.points.push_back({at.x, at.y, 0});
    }
    const auto f = path_figures({ring});
    EXPECT_NEAR(figure(f, "chord error, mm"), radius * (1 - std::cos(pi / n)), 1e-9);
    EXPECT_EQ(figure(f, "turns 45°"), 0);
}

}  // namespace
}  // namespace bead
