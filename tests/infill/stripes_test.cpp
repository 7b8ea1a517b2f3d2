#include "infill/stripes.h"

#include <gtest/gtest.h>

#include "geom/clip.h"
#include "infill/trimmed_ends.h"

namespace bead {
namespace {

Region rectangle(double width, double height) {
    return {{{{0, 0}, {width, 0}, {width, height}, {0, height}}, {}}};
}

Region broad_ring(double inner, double outer) {
    Polygon polygon;
    for (int i = 0; i < 90; ++i) {
        polygon.outer.push_back(outer * unit(2 * pi * i / 90));
        if (polygon.holes.empty()) polygon.holes.emplace_back();
        polygon.holes.front().push_back(inner * unit(-2 * pi * i / 90));
    }
    return {polygon};
}

double length_inside(const std::vector<Polyline>& lines, const Region& region) {
    double sum = 0;
    for (const Polyline& line : inside_parts(lines, region)) sum += length(line);
    return sum;
}

TEST(Stripes, EvenDirectionsGiveStraightLinesAtTheirDistance) {
    const Region region = rectangle(40, 30);
    for (const double angle : {0.0, 0.4, 1.3, 2.5}) {
        const LineField field{[=](Vec2) { return unit(angle); }, [](Vec2) { return 2.5; }};
        const std::vector<Polyline> lines = stripes(region, field, {.seed = 3});
        EXPECT_NEAR(length_inside(lines, region), area(region) / 2.5, 0.06 * area(region) / 2.5)
            << angle;
        for (const Polyline& line : lines)
            for (const Vec2 p : line)
                EXPECT_LT(std::abs(cross(unit(angle), p - line.front())), 0.02) << angle;
    }
}

// A direction is none with a sign: turning it round where one likes changes nothing.
TEST(Stripes, DoNotMindTheSignOfADirection) {
    const Region region = rectangle(40, 30);
    const LineField field{[](Vec2 p) { return unit(0.3 + 0.01 * p.x); }, [](Vec2) { return 3.0; }};
    const LineField turned{[](Vec2 p) {
                               const bool flip = std::sin(7 * p.x + 3 * p.y) > 0;
                               return (flip ? -1.0 : 1.0) * unit(0.3 + 0.01 * p.x);
                           },
                           field.spacing};
    EXPECT_NEAR(length_inside(stripes(region, field, {}), region),
                length_inside(stripes(region, turned, {}), region), 0.05 * area(region) / 3);
}

TEST(Stripes, LieWhereMoreIsAskedFor) {
    const Region region = rectangle(60, 30);
    const LineField field{[](Vec2) {
                              return Vec2{1, 0};
                          },
                          [](Vec2 p) { return p.y < 15 ? 1.0 : 3.0; }};
    const std::vector<Polyline> lines = stripes(region, field, {});
    EXPECT_NEAR(length_inside(lines, rectangle(60, 15)), 900, 120);
    EXPECT_NEAR(length_inside(lines, region), 900 + 300, 150);
}

TEST(Stripes, GoRoundAHole) {
    const Region region = broad_ring(8, 20);
    const LineField round{[](Vec2 p) { return left_of(p) / std::max(length(p), 1e-9); },
                          [](Vec2) { return 2.0; }};
    const std::vector<Polyline> lines = stripes(region, round, {.seed = 1});
    EXPECT_NEAR(length_inside(lines, region), area(region) / 2, 0.08 * area(region) / 2);
    for (const Polyline& line : inside_parts(lines, region))
        for (const Vec2 p : line) EXPECT_NEAR(length(p), length(line.front()), 0.6);
}

TEST(Stripes, AreTheSameForTheSameSeed) {
    const Region region = rectangle(30, 30);
    const LineField field{[](Vec2 p) { return unit(0.05 * p.y); }, [](Vec2) { return 2.0; }};
    EXPECT_EQ(stripes(region, field, {.seed = 5}), stripes(region, field, {.seed = 5}));
    EXPECT_NE(stripes(region, field, {.seed = 5}), stripes(region, field, {.seed = 6}));
}

TEST(TrimmedEnds, AreCutBackToTheLastJoint) {
    const std::vector<FamilyLine> lines{
        {0, {{0, 0}, {20, 0}}}, {1, {{5, -5}, {5, 5}}}, {1, {{12, -5}, {12, 5}}}};
    const std::vector<Polyline> walls{{{-5, -5}, {25, -5}}, {{-5, 5}, {25, 5}}};
    const std::vector<FamilyLine> kept = trimmed_ends(lines, walls, {});
    ASSERT_EQ(kept.size(), 3u);
    EXPECT_NEAR(kept[0].points.front().x, 5, 0.4);
    EXPECT_NEAR(kept[0].points.back().x, 12, 0.4);
    EXPECT_NEAR(length(kept[1].points), 10, 0.3);
}

TEST(TrimmedEnds, WhatTouchesNothingIsLeftOut) {
    const std::vector<FamilyLine> lines{{0, {{0, 0}, {20, 0}}}, {1, {{40, -5}, {40, 5}}}};
    EXPECT_TRUE(trimmed_ends(lines, {}, {}).empty());
}

}  // namespace
}  // namespace bead
