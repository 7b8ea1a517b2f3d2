// G2, G3 and G5.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/error.h"
#include "gcode/arc_centre.h"
#include "gcode/curve.h"
#include "gcode/text.h"

namespace bead {
namespace {

using Centre = std::array<double, 2>;

rc::Gen<Vec2> points() {
    const auto coordinate = rc::gen::map(rc::gen::inRange(-50'000, 50'000),
                                         [](int thousandths) { return thousandths / 1e3; });
    return rc::gen::construct<Vec2>(coordinate, coordinate);
}

// Angle swept from the start to the end of a chord, seen from the centre, above 0 to 2 pi.
double swept(Vec2 chord, Vec2 centre, bool clockwise) {
    const Vec2 from = -centre, to = chord - centre;
    const double left = std::atan2(cross(from, to), dot(from, to));
    const double angle = clockwise ? -left : left;
    return angle > 0 ? angle : angle + 2 * pi;
}

RC_GTEST_PROP(ArcCentre, is_as_far_from_both_ends_as_told, (bool clockwise, bool longer)) {
    const Vec2 chord = *rc::gen::suchThat(points(), [](Vec2 c) { return length(c) > 0.1; });
    const double radius = length(chord) * *rc::gen::inRange(51, 500) / 100.0;
    const auto centre = arc_centre(chord, longer ? -radius : radius, clockwise);
    RC_ASSERT(centre.has_value());
    RC_ASSERT(std::abs(length(*centre) - radius) < 1e-9 * radius);
    RC_ASSERT(std::abs(distance(*centre, chord) - radius) < 1e-9 * radius);
    RC_ASSERT((swept(chord, *centre, clockwise) > pi) == longer);
}

TEST(ArcCentre, is_the_chords_middle_if_the_radius_does_not_reach) {
    EXPECT_EQ(arc_centre({4, 2}, 1, true), (Vec2{2, 1}));
    EXPECT_EQ(arc_centre({4, 2}, 0, true), std::nullopt);
    EXPECT_EQ(arc_centre({}, 1, true), std::nullopt);
}

TEST(Arcs, are_told_by_their_centre_from_the_start) {
    const Reading reading = reading_of(
        "G92 X5 Y6 E1\nM83\nG2 X15 Y16 I10 Z2 E3 F600\nG91\nG3 X-10 J-4 Y-2\nG90\nG2 I1\n");
    const auto arcs = reading.all<Arc>();
    ASSERT_EQ(arcs.size(), 3U);
    EXPECT_EQ(arcs[0].end.to, (Position{15, 16, 2, 4}));
    EXPECT_EQ(arcs[0].centre, (Centre{15, 6}));
    EXPECT_EQ(arcs[0].end.feed, 10);
    EXPECT_EQ(arcs[0].end.role, Role::other);
    EXPECT_TRUE(arcs[0].clockwise);
    EXPECT_EQ(arcs[1].end.to, (Position{5, 14, 2, 4}));
    EXPECT_EQ(arcs[1].centre, (Centre{15, 12}));
    EXPECT_EQ(arcs[1].end.role, Role::travel);
    EXPECT_FALSE(arcs[1].clockwise);
    EXPECT_EQ(arcs[2].end.to, arcs[1].end.to);  // a full circle
    EXPECT_EQ(arcs[2].centre, (Centre{6, 14}));
    EXPECT_EQ(reading.report.malformed, 0);
}

TEST(Arcs, lie_in_the_plane_chosen_and_go_round_more_than_once) {
    const auto arcs = reading_of(
                          "G1 X1 Y2 Z3\nG18\nG2 X5 Z7 I4 K0.5\nG19\nG3 Y9 J1 K2 P3\nG17\n"
                          "G20\nG2 X1 R1\n",
                          Firmware::marlin_jd)
                          .all<Arc>();
    ASSERT_EQ(arcs.size(), 3U);
    EXPECT_EQ(arcs[0].plane, Plane::zx);
    EXPECT_EQ(arcs[0].centre, (Centre{3.5, 5}));
    EXPECT_EQ(arcs[1].plane, Plane::yz);
    EXPECT_EQ(arcs[1].centre, (Centre{3, 9}));
    EXPECT_EQ(arcs[1].more_turns, 3);
    EXPECT_NEAR(std::hypot(arcs[2].centre[0] - 25.4, arcs[2].centre[1] - 9), 25.4, 1e-9);
}

TEST(Arcs, without_a_circle_are_no_moves) {
    for (const char* arc : {"G2 X5 Y5", "G2 X5 I0 J0", "G3 X1 R4", "G2 X5 R0", "G2 X5 I", "G2 F9",
                            "G2 X5 I1 P101", "G2 X5 I1 P-1"}) {
        const Reading reading =
            reading_of("G1 X1 F60\n" + std::string(arc) + "\nG1 Y1\n", Firmware::marlin_jerk);
        EXPECT_TRUE(reading.all<Arc>().empty()) << arc;
        EXPECT_EQ(reading.last<Move>().to, (Position{1, 1, 0, 0})) << arc;
        EXPECT_GE(reading.report.malformed, 1) << arc;
        EXPECT_EQ(reading.report.first_malformed, 2) << arc;
    }
}

TEST(Arcs, of_a_kilometre_are_refused) {
    for (const char* arc : {"G2 X5 I2000000", "G3 X5 J-100000000", "G2 X5 R2000000"})
        EXPECT_THROW(reading_of(arc, Firmware::marlin_jerk), Error) << arc;
}

TEST(Arcs, are_taken_as_each_firmware_takes_them) {
    const auto arcs = [](const char* text, Firmware firmware) {
        return reading_of(std::string("G1 X1\n") + text, firmware).all<Arc>().size();
    };
    EXPECT_EQ(arcs("G2 X5 R4", Firmware::marlin_jd), 1U);
    EXPECT_EQ(arcs("G2 X5 R4", Firmware::prusa), 0U);
    EXPECT_EQ(arcs("G2 X5 R4", Firmware::klipper), 0U);
    EXPECT_EQ(arcs("G91\nG2 X5 I4", Firmware::klipper), 0U);
    EXPECT_EQ(arcs("G2 X5 I4", Firmware::klipper), 1U);
}

RC_GTEST_PROP(Curve, ends_where_it_should_and_stays_within_the_control_points_box, ()) {
    const std::array<Vec2, 4> control{*points(), *points(), *points(), *points()};
    const auto chords = curve_chords(control);
    RC_ASSERT(chords.back().at == control[3]);
    RC_ASSERT(chords.back().share == 1);
    RC_ASSERT(chords.size() >= 5U && chords.size() <= 1000U);
    double before = 0;
    for (const auto& [at, share] : chords) {
        RC_ASSERT(share > before && share - before < 0.2 + 1e-6);
        before = share;
        const auto [low, high] =
            std::minmax({control[0].x, control[1].x, control[2].x, control[3].x});
        RC_ASSERT(at.x >= low - 1e-9 && at.x <= high + 1e-9);
    }
}

TEST(Curve, has_few_chords_where_it_is_straight) {
    EXPECT_LE(curve_chords({Vec2{0, 0}, {1, 0}, {2, 0}, {3, 0}}).size(), 8U);
    EXPECT_GT(curve_chords({Vec2{0, 0}, {0, 80}, {80, -80}, {80, 0}}).size(), 20U);
}

TEST(Curve, becomes_moves_in_marlin_only) {
    const char* const text = "G1 X10 Y10\nG5 X30 Y10 Z1 E4 I0 J10 P0 Q10 F600\nG1 Y9\n";
    const Reading marlin = reading_of(text, Firmware::marlin_jd);
    const auto moves = marlin.all<Move>();
    ASSERT_GT(moves.size(), 7U);
    const Move& end = moves[moves.size() - 2];
    EXPECT_EQ(end.to, (Position{30, 10, 1, 4}));
    double highest = 0, extruded = 0;
    for (const Move& move : moves) {
        highest = std::max(highest, move.to[axis_y]);
        EXPECT_GE(move.to[axis_e], extruded);
        extruded = move.to[axis_e];
    }
    EXPECT_NEAR(highest, 17.5, 0.1);
    EXPECT_EQ(reading_of(text).report.ignored.at("G5 (not obeyed by prusa)"), 1);
    EXPECT_EQ(reading_of(text, Firmware::klipper).all<Move>().size(), 2U);
}

}  // namespace
}  // namespace bead
