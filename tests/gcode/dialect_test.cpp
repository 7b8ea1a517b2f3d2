// The same text as each firmware takes it.
#include <gtest/gtest.h>

#include "gcode/key_words.h"
#include "gcode/text.h"

namespace bead {
namespace {

const double none = -1;  // in the place of a value that is not there

double last_e(const std::string& text, Firmware firmware) {
    return reading_of(text, firmware).last<Move>().to[axis_e];
}

// What "G1 E1" after E 5 comes to: 1 if absolute, 6 if relative.
TEST(Dialect, decides_whether_g90_and_g91_switch_the_extruder) {
    struct Row {
        const char* modes;
        double prusa, prusa_2017, marlin, klipper;
    };
    for (const Row& row : {Row{"", 1, 1, 1, 1}, Row{"G91\n", 1, 6, 6, 6}, Row{"M83\n", 6, 6, 6, 6},
                           Row{"M83\nG90\n", 6, 6, 1, 6}, Row{"G91\nM82\n", 1, 6, 1, 6},
                           Row{"M83\nG91\nG90\n", 6, 6, 1, 6}, Row{"G91\nG90\n", 1, 1, 1, 1}}) {
        const std::string text = "G1 E5\n" + std::string(row.modes) + "G1 E1\n";
        EXPECT_EQ(last_e(text, Firmware::prusa), row.prusa) << row.modes;
        EXPECT_EQ(last_e(text, Firmware::prusa_2017), row.prusa_2017) << row.modes;
        EXPECT_EQ(last_e(text, Firmware::marlin_jerk), row.marlin) << row.modes;
        EXPECT_EQ(last_e(text, Firmware::marlin_jd), row.marlin) << row.modes;
        EXPECT_EQ(last_e(text, Firmware::s_curve), row.marlin) << row.modes;
        EXPECT_EQ(last_e(text, Firmware::klipper), row.klipper) << row.modes;
        EXPECT_EQ(last_e("; FLAVOR:RepRap\n" + text, Firmware::marlin_jd), row.prusa) << row.modes;
    }
}

TEST(Dialect, decides_what_m204_means) {
    const auto limits = [](const char* text, Firmware firmware) {
        return reading_of(std::string("G28\n") + text, firmware).last<SetLimits>();
    };
    const SetLimits prusa = limits("M204 S500 T400", Firmware::prusa);
    EXPECT_EQ(prusa.acceleration, 500);
    EXPECT_EQ(prusa.travel_acceleration, 500);
    EXPECT_EQ(prusa.retract_acceleration, 400);
    EXPECT_EQ(limits("M204 P500 T400", Firmware::prusa).travel_acceleration, 400);
    EXPECT_EQ(limits("M204 P500 T400", Firmware::prusa_2017).retract_acceleration, 400);
    EXPECT_FALSE(limits("M204 P500 T400", Firmware::prusa_2017).acceleration);
    EXPECT_EQ(limits("M204 S500 T400", Firmware::marlin_jd).travel_acceleration, 400);
    EXPECT_EQ(limits("M204 S500 T400", Firmware::klipper).max_acceleration_head, 500);
    EXPECT_EQ(limits("M204 P500 T400", Firmware::klipper).max_acceleration_head, 400);
    EXPECT_FALSE(limits("M204 P500 T400", Firmware::klipper).acceleration);
    EXPECT_TRUE(reading_of("G28\nM204 P500", Firmware::klipper).all<SetLimits>().empty());
}

TEST(Dialect, passes_over_what_the_firmware_does_not_know) {
    const char* const text =
        "G28\nM201 X9\nM203 X9\nM205 X9 J0.1 B20000\nSET_VELOCITY_LIMIT ACCEL=5\nG18\n";
    const Reading klipper = reading_of(text, Firmware::klipper);
    EXPECT_EQ(klipper.all<SetLimits>().size(), 1U);
    EXPECT_EQ(klipper.report.ignored.size(), 3U);
    EXPECT_EQ(klipper.report.ignored.at("M201 (not obeyed by klipper)"), 1);
    const Reading prusa = reading_of(text, Firmware::prusa);
    EXPECT_EQ(prusa.all<SetLimits>().size(), 3U);
    EXPECT_FALSE(prusa.last<SetLimits>().junction_deviation);
    EXPECT_EQ(prusa.report.ignored.at("SET_VELOCITY_LIMIT (not obeyed by prusa)"), 1);
    EXPECT_EQ(prusa.report.ignored.at("G18 (not obeyed by prusa)"), 1);
    EXPECT_EQ(reading_of(text, Firmware::marlin_jd).last<SetLimits>().junction_deviation, 0.1);
    EXPECT_EQ(reading_of("G28\nG4 S2\n", Firmware::klipper).last<Dwell>().duration, 0);
}

TEST(Dialect, of_klipper_sets_its_limits_by_name) {
    const auto limits =
        reading_of(
            "G28\nSET_VELOCITY_LIMIT VELOCITY=300 accel=5000 SQUARE_CORNER_VELOCITY=8 ; ACCEL=1\n"
            "set_velocity_limit ACCEL_TO_DECEL=2500\n"
            "SET_VELOCITY_LIMIT ACCEL=\"1000\" ACCEL_TO_DECEL=4000\n"
            "SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO=0.25\n"
            "SET_VELOCITY_LIMIT ACCEL=-1 VELOCITY=fast MINIMUM_CRUISE_RATIO=1\n",
            Firmware::klipper)
            .all<SetLimits>();
    ASSERT_EQ(limits.size(), 4U);
    EXPECT_EQ(limits[0].max_velocity, 300);
    EXPECT_EQ(limits[0].max_acceleration_head, 5000);
    EXPECT_EQ(limits[0].square_corner_velocity, 8);
    EXPECT_FALSE(limits[0].minimum_cruise_ratio);
    EXPECT_EQ(limits[1].minimum_cruise_ratio, 0.5);
    EXPECT_FALSE(limits[1].max_acceleration_head);
    EXPECT_EQ(limits[2].minimum_cruise_ratio, 0);
    EXPECT_EQ(limits[2].max_acceleration_head, 1000);
    EXPECT_EQ(limits[3].minimum_cruise_ratio, 0.25);
}

TEST(Dialect, of_klipper_saves_and_restores_its_state) {
    const auto moves =
        reading_of(
            "G1 X10 Y10 E5 F600\nSAVE_GCODE_STATE NAME=a\nG91\nG1 X1 E1 F1200\nG92 X0 E0\nG1 X1\n"
            "RESTORE_GCODE_STATE NAME=a\nG1 Y20 E6\nRESTORE_GCODE_STATE NAME=a MOVE=1 "
            "MOVE_SPEED=50\nG1 Y11\n",
            Firmware::klipper)
            .all<Move>();
    ASSERT_EQ(moves.size(), 6U);
    // G92 called X 11 by 0: commands count 11 less than the file does again.
    EXPECT_EQ(moves[2].to, (Position{1, 10, 0, 0}));
    EXPECT_EQ(moves[3].to, (Position{1, 20, 0, 1}));  // E6 after the saved E5
    EXPECT_EQ(moves[3].feed, 10);
    EXPECT_EQ(moves[4].to, (Position{-1, 10, 0, 1}));
    EXPECT_EQ(moves[4].feed, 50);
    EXPECT_EQ(moves[5].to, (Position{-1, 11, 0, 1}));
    EXPECT_EQ(moves[5].feed, 10);
    EXPECT_EQ(reading_of("G28\nRESTORE_GCODE_STATE NAME=b", Firmware::klipper).report.malformed, 1);
}

TEST(Dialect, of_reprapfirmware_counts_speeds_by_the_minute) {
    for (const char* flavor : {"; gcode_flavor = reprapfirmware\n", ";FLAVOR:RepRap\n"}) {
        const Reading reading = reading_of(std::string(flavor) + "M203 X6000\nM566 X480 Y0\nG28\n");
        EXPECT_EQ(reading.all<SetLimits>()[0].max_feedrate[axis_x], 100);
        EXPECT_EQ(reading.all<SetLimits>()[1].jerk[axis_x], 8);
        EXPECT_EQ(reading.all<SetLimits>()[1].jerk[axis_y], 0);
        EXPECT_EQ(reading.report.dialect, "RepRapFirmware");
    }
    EXPECT_EQ(reading_of(";FLAVOR:Marlin\nM203 X100\nG28\n").last<SetLimits>().max_feedrate[axis_x],
              100);
    EXPECT_EQ(reading_of("G28\n").report.dialect, "prusa");
}

TEST(Dialect, of_reprapfirmware_is_known_by_m566_and_sets_right_what_came_before) {
    const auto limits = reading_of("M203 X6000 Z600\nM203 Z660\nM566 X480\nM203 Y1200\nG28\n",
                                   Firmware::marlin_jerk)
                            .all<SetLimits>();
    ASSERT_EQ(limits.size(), 5U);
    EXPECT_EQ(limits[2].max_feedrate[axis_x].value_or(none), 100);
    EXPECT_EQ(limits[2].max_feedrate[axis_z].value_or(none), 11);
    EXPECT_FALSE(limits[2].max_feedrate[axis_y]);
    EXPECT_EQ(limits[3].jerk[axis_x].value_or(none), 8);
    EXPECT_EQ(limits[4].max_feedrate[axis_y].value_or(none), 20);
    const Reading klipper = reading_of("M566 X480\nG28\n", Firmware::klipper);
    EXPECT_EQ(klipper.report.dialect, "klipper");
    EXPECT_TRUE(klipper.all<SetLimits>().empty());
}

TEST(Dialect, of_a_file_is_not_decided_by_its_end) {
    EXPECT_EQ(reading_of("G1 X1\n; gcode_flavor = reprapfirmware\n").report.dialect, "prusa");
}

TEST(KeyWords, are_found_by_name) {
    EXPECT_EQ(value_of(" NAME=a B='two' c=3;D=4", "b"), "two");
    EXPECT_EQ(value_of("NAME=a", "NAM"), std::nullopt);
    EXPECT_EQ(value_of("X=1 ;Y=2", "Y"), std::nullopt);
    EXPECT_EQ(number_of("A=1.5 B=x", "A").value, 1.5);
    EXPECT_TRUE(number_of("A=1.5 B=x", "B").named);
    EXPECT_FALSE(number_of("A=1.5 B=x", "B").value);
    EXPECT_FALSE(number_of("A=1e300", "A").value);
    EXPECT_FALSE(number_of("A=", "A").value);
}

}  // namespace
}  // namespace bead
