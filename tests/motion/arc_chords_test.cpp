#include "motion/arc_chords.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/vec.h"

namespace bead {
namespace {

std::vector<Move> chords_of(const Arc& arc, const Position& from, ArcStyle style) {
    std::vector<Move> chords;
    each_chord(arc, from, {style, 1}, [&](const Move& move) { chords.push_back(move); });
    return chords;
}

// Counter-clockwise about the origin from (r, 0) by the angle, rising by 1 mm.
Arc turned(double r, double angle) {
    Arc arc;
    arc.end = {{r * std::cos(angle), r * std::sin(angle), 1, 2}, 40, Role::wall, {}};
    return arc;
}

class EveryStyle : public testing::TestWithParam<ArcStyle> {};

TEST_P(EveryStyle, ChordsEndWhereTheArcDoesAndStayOnTheCircle) {
    for (const double r : {3.0, 20.0, 150.0})
        for (const double angle : {0.1, 1.0, 3.0, 6.0}) {
            const Position from{r, 0, 0, 0};
            const auto chords = chords_of(turned(r, angle), from, GetParam());
            ASSERT_FALSE(chords.empty());
            EXPECT_EQ(chords.back().to, turned(r, angle).end.to);
            Position at = from;
            for (const Move& chord : chords) {
                // The small-angle matrix spirals on circles of few chords, as in the firmware.
                EXPECT_NEAR(std::hypot(chord.to[0], chord.to[1]), r,
                            (r < 1   ? 0.12
                             : r < 5 ? 0.04
                                     : 0.01) *
                                r);
                EXPECT_GE(chord.to[axis_z], at[axis_z]);
                at = chord.to;
            }
        }
}

TEST_P(EveryStyle, ClockwiseIsTheMirrorImage) {
    Arc there = turned(10, 2), mirrored = there;
    mirrored.clockwise = true;
    mirrored.end.to[axis_y] *= -1;
    const auto a = chords_of(there, {10, 0, 0, 0}, GetParam());
    const auto b = chords_of(mirrored, {10, 0, 0, 0}, GetParam());
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i].to[axis_x], b[i].to[axis_x], 1e-12);
        EXPECT_NEAR(a[i].to[axis_y], -b[i].to[axis_y], 1e-12);
    }
}

TEST_P(EveryStyle, MoreTurnsAreWholeCirclesWithTheirShareOfTheRise) {
    Arc arc = turned(10, pi);
    const auto plain = chords_of(arc, {10, 0, 0, 0}, GetParam());
    arc.more_turns = 2;
    const auto more = chords_of(arc, {10, 0, 0, 0}, GetParam());
    EXPECT_GT(more.size(), 4.5 * double(plain.size()));
    EXPECT_EQ(more.back().to, arc.end.to);
}

TEST_P(EveryStyle, APointIsNoArc) {
    Arc arc;
    arc.end.to = {5, 5, 0, 1};
    arc.centre = {5, 5};
    EXPECT_TRUE(chords_of(arc, {5, 5, 0, 0}, GetParam()).empty());
}

INSTANTIATE_TEST_SUITE_P(All, EveryStyle,
                         testing::Values(ArcStyle::prusa, ArcStyle::prusa_2017, ArcStyle::marlin,
                                         ArcStyle::klipper));

// A quarter of a circle of radius 10 mm is 15.7 mm long.
TEST(ArcChords, AreAsManyAsTheFirmwaresMake) {
    Arc arc = turned(10, pi / 2);
    arc.end.to[axis_z] = 0;
    EXPECT_EQ(chords_of(arc, {10, 0, 0, 0}, ArcStyle::prusa).size(), 16U);
    EXPECT_EQ(chords_of(arc, {10, 0, 0, 0}, ArcStyle::prusa_2017).size(), 15U);
    EXPECT_EQ(chords_of(arc, {10, 0, 0, 0}, ArcStyle::marlin).size(), 18U);
    EXPECT_EQ(chords_of(arc, {10, 0, 0, 0}, ArcStyle::klipper).size(), 15U);
}

TEST(ArcChords, OtherPlanes) {
    Arc arc;
    arc.plane = Plane::zx;
    arc.end.to = {10, 0, 0, 0};  // from z = 10 to x = 10 about the origin
    for (const Move& chord : chords_of(arc, {0, 0, 10, 0}, ArcStyle::klipper)) {
        EXPECT_NEAR(std::hypot(chord.to[axis_z], chord.to[axis_x]), 10, 1e-9);
        EXPECT_EQ(chord.to[axis_y], 0);
    }
}

}  // namespace
}  // namespace bead
