// G10 and G11: the firmware moves the filament, and the file goes on counting as if it had not.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "gcode/text.h"

namespace bead {
namespace {

// Where the machine is in X, Y, Z, E after each command, counted since the beginning whatever G92
// calls it.
std::vector<Position> machine_places(const std::vector<Command>& commands) {
    std::vector<Position> places;
    Position machine{}, commanded{};
    for (const Command& command : commands) {
        if (const auto* const move = std::get_if<Move>(&command.what)) {
            for (std::size_t i = 0; i < machine.size(); ++i)
                machine[i] += move->to[i] - commanded[i];
            commanded = move->to;
        } else if (const auto* const set = std::get_if<SetPosition>(&command.what)) {
            for (std::size_t i = 0; i < machine.size(); ++i)
                commanded[i] = set->to[i].value_or(commanded[i]);
        }
        places.push_back(machine);
    }
    return places;
}

TEST(Retraction, pulls_the_filament_back_once_and_returns_it_once) {
    const Reading reading = reading_of("G1 X1 E5 F600\nG10\nG10\nG1 X2\nG11\nG11\nG1 X3 E6\n");
    const auto moves = reading.all<Move>();
    ASSERT_EQ(moves.size(), 5U);
    EXPECT_EQ(moves[1].to, (Position{1, 0, 0, 2}));
    EXPECT_EQ(moves[1].feed, 45);
    EXPECT_EQ(moves[1].role, Role::travel);
    EXPECT_EQ(moves[2].to, (Position{2, 0, 0, 2}));
    EXPECT_EQ(moves[2].feed, 10);
    EXPECT_EQ(moves[3].to, (Position{2, 0, 0, 5}));
    EXPECT_EQ(moves[3].feed, 8);
    EXPECT_EQ(moves[4].to, (Position{3, 0, 0, 6}));
    EXPECT_EQ(moves[4].role, Role::other);
}

TEST(Retraction, leaves_every_g92_as_the_file_has_it) {
    const Reading reading = reading_of("G1 X1 E5\nG10\nG92 E0\nG11\nG1 X2 E1\nG92 E0\nG1 X3 E1\n");
    for (const SetPosition& position : reading.all<SetPosition>())
        EXPECT_EQ(position.to[axis_e], 0);
    const auto places = machine_places(reading.commands);
    EXPECT_EQ(places.back()[axis_e], 7);
}

TEST(Retraction, lifts_the_head_first_up_last_down) {
    const Reading reading = reading_of(
        "M207 S1.5 F1800 Z0.6\nM208 S0.25 F600\nG1 X1 Z0.2\nG10\nG1 X5 Z0.4\nG11\nG1 X6\n");
    const auto moves = reading.all<Move>();
    ASSERT_EQ(moves.size(), 7U);
    EXPECT_EQ(moves[1].to, (Position{1, 0, 0.2, -1.5}));
    EXPECT_EQ(moves[1].feed, 30);
    EXPECT_EQ(moves[2].to, (Position{1, 0, 0.2 + 0.6, -1.5}));
    EXPECT_EQ(moves[3].to, (Position{5, 0, 0.4 + 0.6, -1.5}));
    EXPECT_EQ(moves[4].to[axis_z], 0.4);
    EXPECT_EQ(moves[5].to, (Position{5, 0, 0.4, 0.25}));
    EXPECT_EQ(moves[5].feed, 10);
    EXPECT_EQ(moves[6].to, (Position{6, 0, 0.4, 0.25}));
}

TEST(Retraction, is_not_meant_by_tool_offsets) {
    const Reading reading = reading_of("G1 X1\nG10 P0 S210 R180\nG10 L2 X5\nG11\n");
    EXPECT_EQ(reading.commands.size(), 1U);
    EXPECT_EQ(reading.report.ignored.at("G10 (not a retraction)"), 2);
}

TEST(Retraction, is_nothing_in_klipper_until_it_is_told) {
    const Reading untold = reading_of("G1 X1\nG10\nG11\nM207 S3\n", Firmware::klipper);
    EXPECT_EQ(untold.commands.size(), 1U);
    EXPECT_EQ(untold.report.ignored.at("M207 (not obeyed by klipper)"), 1);
    const auto moves = reading_of(
                           "SET_RETRACTION RETRACT_LENGTH=0.8 RETRACT_SPEED=35\nG1 X1\nG10\n"
                           "G11\n",
                           Firmware::klipper)
                           .all<Move>();
    ASSERT_EQ(moves.size(), 3U);
    EXPECT_EQ(moves[1].to[axis_e], -0.8);
    EXPECT_EQ(moves[1].feed, 35);
    EXPECT_EQ(moves[2].to[axis_e], 0);
    EXPECT_EQ(moves[2].feed, 10);
}

// Twin: the same print without G10 and G11. The machine's places differ by the filament pulled
// back, and only between the two.
RC_GTEST_PROP(Retraction, changes_nothing_but_the_filaments_place_in_between, ()) {
    const std::vector<std::string> lines{"G1 X1 E2", "G1 Y5",  "G92 E0",   "G92 X3 E7", "M83",
                                         "M82",      "G1 E-1", "G1 Z1 E3", "G91",       "G90"};
    std::string with, without;
    std::vector<bool> expected;  // by line: pulled back
    bool pulled = false;
    for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 14))) {
        const bool swaps = choice >= int(lines.size());
        const std::string line = swaps ? "" : lines[std::size_t(choice)];
        if (swaps) pulled = !pulled;
        with += (swaps ? (pulled ? "G10" : "G11") : line) + "\n";
        without += line + "\n";
        expected.push_back(pulled);
    }
    const Reading a = reading_of("G28\n" + with, Firmware::marlin_jd);
    const Reading b = reading_of("G28\n" + without, Firmware::marlin_jd);
    const auto by_line = [&](const Reading& reading) {
        std::vector<Position> places(expected.size() + 1);
        const auto all = machine_places(reading.commands);
        std::size_t next = 0;
        for (std::size_t line = 0; line < places.size(); ++line) {
            if (line > 0) places[line] = places[line - 1];
            for (; next < all.size() && reading.commands[next].line <= std::int64_t(line) + 1;
                 ++next)
                places[line] = all[next];
        }
        return places;
    };
    const auto places = by_line(a), plain = by_line(b);
    for (std::size_t line = 0; line < expected.size(); ++line) {
        for (const Axis axis : {axis_x, axis_y, axis_z})
            RC_ASSERT(places[line + 1][axis] == plain[line + 1][axis]);
        const double back = expected[line] ? 3 : 0;
        RC_ASSERT(std::abs(places[line + 1][axis_e] + back - plain[line + 1][axis_e]) < 1e-9);
    }
}

}  // namespace
}  // namespace bead
