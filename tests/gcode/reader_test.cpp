#include "gcode/reader.h"

#include <gtest/gtest.h>

#include "gcode/text.h"

namespace bead {
namespace {

const double no_word = -1;  // in the place of a value that is not there

TEST(Reader, keeps_the_whole_place_between_moves) {
    const auto moves = reading_of("G1 X1 Y2 F600\nG1 Z3\nG0 E4 F1200\nG1 X5\n").all<Move>();
    ASSERT_EQ(moves.size(), 4U);
    EXPECT_EQ(moves[0].to, (Position{1, 2, 0, 0}));
    EXPECT_EQ(moves[1].to, (Position{1, 2, 3, 0}));
    EXPECT_EQ(moves[3].to, (Position{5, 2, 3, 4}));
    EXPECT_EQ(moves[1].feed, 10);
    EXPECT_EQ(moves[3].feed, 20);
}

TEST(Reader, gives_each_command_its_line) {
    const Reading reading = reading_of("; top\n\nG28\nM104 S200\nG1 X1\n");
    ASSERT_EQ(reading.commands.size(), 3U);
    EXPECT_EQ(reading.commands[0].line, 3);
    EXPECT_EQ(reading.commands[2].line, 5);
    EXPECT_EQ(reading.report.lines, 5);
    EXPECT_EQ(reading.report.bytes, 27);
}

TEST(Reader, takes_a_feed_alone_for_the_moves_to_come) {
    const auto moves = reading_of("G1 F3000\nG1 X1\nG1 F0\nG1 X2\nG1 X3 F-5\n").all<Move>();
    ASSERT_EQ(moves.size(), 3U);
    for (const Move& move : moves) EXPECT_EQ(move.feed, 50);
}

TEST(Reader, starts_with_the_feed_it_is_given) {
    EXPECT_EQ(reading_of("G1 X1").last<Move>().feed, ReadOptions{}.first_feed);
}

TEST(Reader, adds_relative_places) {
    const auto moves =
        reading_of("G1 X10 E5\nG91\nG1 X1 Z2 E6\nG1 X1 E7\nG90\nG1 X1\n").all<Move>();
    EXPECT_EQ(moves[1].to, (Position{11, 0, 2, 6}));  // G91 leaves E alone
    EXPECT_EQ(moves[2].to, (Position{12, 0, 2, 7}));
    EXPECT_EQ(moves[3].to, (Position{1, 0, 2, 7}));
}

TEST(Reader, adds_relative_extrusion) {
    const auto moves = reading_of("M83\nG1 X1 E.5\nG1 X2 E.5\nM82\nG1 X3 E3\n").all<Move>();
    EXPECT_EQ(moves[1].to, (Position{2, 0, 0, 1}));
    EXPECT_EQ(moves[2].to, (Position{3, 0, 0, 3}));
}

TEST(Reader, renames_the_place_by_g92) {
    const Reading reading =
        reading_of("G1 X10 Y20 E5\nG92 X1 E0\nG91\nM83\nG1 X1 E1\nG92\nG1 Y1\n");
    const auto moves = reading.all<Move>();
    EXPECT_EQ(moves[1].to, (Position{2, 20, 0, 1}));
    EXPECT_EQ(moves[2].to, (Position{0, 1, 0, 0}));
    const auto positions = reading.all<SetPosition>();
    EXPECT_EQ(positions[0].to[axis_x].value_or(no_word), 1);
    EXPECT_FALSE(positions[0].to[axis_y]);
    for (const auto& axis : positions[1].to) EXPECT_EQ(axis.value_or(no_word), 0);
}

TEST(Reader, scales_inches) {
    const Reading reading = reading_of("G20\nG1 X1 Y2 Z3 E4 F60\nG92 X2\nG21\nG1 Y1 F60\n");
    const auto moves = reading.all<Move>();
    EXPECT_EQ(moves[0].to, (Position{25.4, 50.8, 3 * 25.4, 4 * 25.4}));
    EXPECT_DOUBLE_EQ(moves[0].feed, 25.4);
    EXPECT_EQ(moves[1].to[axis_x], 50.8);
    EXPECT_EQ(moves[1].feed, 1);
}

TEST(Reader, homes_all_axes_or_those_named) {
    const Reading reading = reading_of("G1 X1 Y2 Z3\nG28 X Y0\nG1 E1\nG28 W\nG1 E2\n");
    EXPECT_EQ(reading.all<Home>()[0].axes, (std::array{true, true, false}));
    EXPECT_EQ(reading.all<Home>()[1].axes, (std::array{true, true, true}));
    EXPECT_EQ(reading.all<Move>()[1].to, (Position{0, 0, 3, 1}));
    EXPECT_EQ(reading.all<Move>()[2].to, (Position{0, 0, 0, 2}));
    EXPECT_EQ(reading.report.malformed, 0);
}

TEST(Reader, waits_heats_and_blows) {
    const Reading reading = reading_of(
        "G28\nG4 P500\nG4 S2 P1\nM400\nM104 S215\nM109 R180\nM140 S60\nM190 S65\nM106 "
        "S51\nM106\nM107\n");
    EXPECT_EQ(reading.all<Dwell>()[0].duration, 0.5);
    EXPECT_EQ(reading.all<Dwell>()[1].duration, 2);
    EXPECT_EQ(reading.all<Drain>().size(), 1U);
    const auto heats = reading.all<SetHeat>();
    ASSERT_EQ(heats.size(), 4U);
    EXPECT_EQ(heats[1].celsius, 180);
    EXPECT_TRUE(heats[1].wait && heats[3].wait);
    EXPECT_FALSE(heats[0].wait || heats[2].wait);
    EXPECT_EQ(heats[2].heater, Heater::bed);
    const auto fans = reading.all<SetFan>();
    EXPECT_EQ(fans[0].duty, 0.2);
    EXPECT_EQ(fans[1].duty, 1);
    EXPECT_EQ(fans[2].duty, 0);
}

TEST(Reader, takes_limits_from_the_file) {
    const auto limits = reading_of(
                            "G28\nM201 X900 E5000\nM203 Z12\nM205 X8 Y0\nM204 P800 R700 T600\n"
                            "M204 S500\nM204 S500 T400\n",
                            Firmware::marlin_jerk)
                            .all<SetLimits>();
    ASSERT_EQ(limits.size(), 6U);
    EXPECT_EQ(limits[0].max_acceleration[axis_x].value_or(no_word), 900);
    EXPECT_FALSE(limits[0].max_acceleration[axis_y] || limits[0].acceleration);
    EXPECT_EQ(limits[1].max_feedrate[axis_z].value_or(no_word), 12);
    EXPECT_EQ(limits[2].jerk[axis_x].value_or(no_word), 8);
    EXPECT_EQ(limits[2].jerk[axis_y].value_or(no_word), 0);
    EXPECT_EQ(limits[3].retract_acceleration.value_or(no_word), 700);
    EXPECT_EQ(limits[4].acceleration.value_or(no_word), 500);
    EXPECT_EQ(limits[4].travel_acceleration.value_or(no_word), 500);
    EXPECT_FALSE(limits[4].retract_acceleration);
    EXPECT_EQ(limits[5].travel_acceleration.value_or(no_word), 400);
}

TEST(Reader, counts_what_it_passes_over) {
    const Reading reading = reading_of(
        "G28\nT0\nM73 P1\nm117 P2\nM117 P\nM601\nG92.1 X5\nM106 P1 S9\nM204 S0\nM104\nPRINT_START "
        "BED=60\nG90 G1 "
        "X5\n");
    const std::map<std::string, std::int64_t> expected{{"T0 (tool change)", 1},
                                                       {"M117", 2},
                                                       {"G92.1", 1},
                                                       {"M106 (of another fan)", 1},
                                                       {"M204", 1},
                                                       {"M104", 1},
                                                       {"PRINT_START (macro)", 1},
                                                       {"G1 (second on its line)", 1},
                                                       {"M601 (pause)", 1}};
    EXPECT_EQ(reading.report.ignored, expected);
    EXPECT_EQ(reading.commands.size(), 2U);
    EXPECT_EQ(reading.all<Drain>().size(), 1U);
    EXPECT_EQ(reading.report.malformed, 0);
}

TEST(Reader, bounds_the_names_it_counts) {
    std::string text = "G28\n";
    for (int i = 0; i < 1000; ++i)
        text.append("NAME_").append(500, char('A' + i % 26)).append("\n");
    for (int i = 0; i < 1000; ++i) text.append("M").append(std::to_string(5000 + i)).append("\n");
    const Reading reading = reading_of(text);
    EXPECT_LE(reading.report.ignored.size(), 201U);
    std::int64_t sum = 0;
    for (const auto& [name, count] : reading.report.ignored) sum += count;
    EXPECT_EQ(sum, 2000);
}

}  // namespace
}  // namespace bead
