#include "job/klipper_config.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>

#include "job/limit_table.h"
#include "support/job_errors.h"

namespace bead {
namespace {

using test::complaint_of;
using test::says;

PrinterFile read(const std::string& text) { return read_klipper_config({"printer.cfg", text}, {}); }

std::string source_of(const PrinterFile& file, std::string_view limit, std::size_t axis = 0) {
    for (const StatedLimit& stated : file.says.limits)
        if (stated.name == limit && stated.axis == axis) return stated.source;
    return "nowhere";
}

const std::string least = "[printer]\nmax_velocity: 300\nmax_accel: 3000\n";

TEST(KlipperConfig, SaysWhatTheMachineMovesBy) {
    const PrinterFile file = read(
        "# a voron\n"
        "[include macros.cfg]\n"
        "[printer]\nkinematics: corexy\nmax_velocity: 300 ; fast\nmax_accel = 3000  # strong\n"
        "max_z_velocity: 15\nmax_z_accel: 350\nsquare_corner_velocity: 6\n"
        "[gcode_macro START]\ngcode:\n  G28\n  max_velocity: 7\n"
        "[gcode_arcs]\nresolution: 0.1\n"
        "[stepper_x]\nstep_pin: PF0\nrotation_distance: 40\nmicrosteps: 16\nposition_max: 350\n"
        "[stepper_y]\nposition_max: 340\n"
        "[stepper_z]\nrotation_distance: 40\nmicrosteps: 32\ngear_ratio: 80:16, 2:1\n"
        "full_steps_per_rotation: 400\nposition_max: 330\n"
        "[extruder]\nnozzle_diameter: 0.6\nfilament_diameter: 1.75\nmax_extrude_only_velocity: 60\n"
        "instantaneous_corner_velocity: 2\n");
    const Printer& p = file.printer;
    EXPECT_EQ(p.kinematics, Kinematics::corexy);
    EXPECT_EQ(p.bed, (std::array<double, 3>{350, 340, 330}));
    EXPECT_EQ(p.nozzle, 0.6);
    const Limits& l = p.limits;
    EXPECT_EQ(l.max_feedrate, (std::array<double, 4>{300, 300, 15, 60}));
    EXPECT_EQ(l.acceleration, 3000);
    EXPECT_EQ(l.max_acceleration[2], 350);
    EXPECT_EQ(l.square_corner_velocity, 6);
    EXPECT_EQ(l.minimum_cruise_ratio, 0.5);
    EXPECT_EQ(l.extrude_only_velocity, 60);
    EXPECT_EQ(l.instantaneous_corner_velocity, 2);
    EXPECT_EQ(l.arc_resolution, 0.1);
    EXPECT_EQ(l.steps_per_mm[0], 200 * 16 / 40.);
    EXPECT_EQ(l.steps_per_mm[2], 400 * 32 * 10 / 40.);
    EXPECT_EQ(file.says.firmware->firmware, Firmware::klipper);
    EXPECT_EQ(source_of(file, "acceleration_mm_s2"), "printer.cfg:6 (max_accel)");
    EXPECT_EQ(source_of(file, "steps_per_mm", 1), "nowhere");
    ASSERT_EQ(file.says.warnings.size(), 1U);
    EXPECT_TRUE(says(file.says.warnings[0], "macros.cfg"));
    ASSERT_EQ(file.says.notes.size(), 1U);
    EXPECT_TRUE(says(file.says.notes[0], "prusa-mk3s"));
}

// An XY move with a bead of 4 nozzle diameters squared sets what the filament alone may do.
TEST(KlipperConfig, HasKlippersDefaults) {
    const PrinterFile file =
        read(least + "[extruder]\nnozzle_diameter: 0.4\nfilament_diameter: 1.75\n");
    const Limits& l = file.printer.limits;
    const double ratio = 4 * 0.4 * 0.4 / (std::numbers::pi * 0.875 * 0.875);
    EXPECT_NEAR(l.extrude_only_velocity, 300 * ratio, 1e-9);
    EXPECT_NEAR(l.extrude_only_acceleration, 3000 * ratio, 1e-9);
    EXPECT_EQ(l.max_feedrate[2], 300);
    EXPECT_EQ(l.max_acceleration[2], 3000);
    EXPECT_EQ(l.square_corner_velocity, 5);
    EXPECT_EQ(l.instantaneous_corner_velocity, 1);
    EXPECT_EQ(source_of(file, "square_corner_velocity_mm_s"), "Klipper's default");
}

TEST(KlipperConfig, OlderNamesMeanTheSame) {
    EXPECT_EQ(read(least + "max_accel_to_decel: 1500\n").printer.limits.minimum_cruise_ratio, 0.5);
    EXPECT_EQ(read(least + "max_accel_to_decel: 750\n").printer.limits.minimum_cruise_ratio, 0.75);
    EXPECT_EQ(read(least + "max_accel_to_decel: 9000\n").printer.limits.minimum_cruise_ratio, 0);
    EXPECT_EQ(read(least + "max_accel_to_decel: 9\nminimum_cruise_ratio: 0.2\n")
                  .printer.limits.minimum_cruise_ratio,
              0.2);
    EXPECT_EQ(read(least + "[stepper_y]\nstep_distance: 0.0125\n").printer.limits.steps_per_mm[1],
              80);
}

TEST(KlipperConfig, OfADeltaHasItsTowers) {
    const Printer p = read(least +
                           "kinematics: delta\ndelta_radius: 174.75\nprint_radius: 140\n"
                           "[stepper_a]\narm_length: 333\nposition_endstop: 297.05\n"
                           "rotation_distance: 40\nmicrosteps: 16\n")
                          .printer;
    EXPECT_EQ(p.kinematics, Kinematics::delta);
    EXPECT_EQ(p.delta.radius, 174.75);
    EXPECT_EQ(p.delta.arm, 333);
    EXPECT_EQ(p.bed, (std::array<double, 3>{280, 280, 297.05}));
    EXPECT_EQ(p.limits.steps_per_mm[0], 80);
}

TEST(KlipperConfig, RefusesWhatKlipperWouldNot) {
    const auto complaint = [](const std::string& text) {
        return complaint_of([&] { read(text); });
    };
    EXPECT_TRUE(says(complaint(""), "max_velocity"));
    EXPECT_TRUE(says(complaint("[printer]\nmax_velocity: 9\n[include a.cfg]\n"), "not followed"));
    for (const std::string value :
         {"0", "-1", "nan", "inf", "1e300", "fast", "", "3,5", "1e-300"}) {
        EXPECT_TRUE(
            says(complaint("[printer]\nmax_velocity: 9\nmax_accel: " + value), "cfg:3: max_accel"))
            << value;
        EXPECT_TRUE(says(complaint(least + "[stepper_x]\nrotation_distance: " + value), "cfg:5:"));
    }
    EXPECT_TRUE(says(complaint(least + "minimum_cruise_ratio: 1\n"), "cfg:4:"));
    for (const std::string ratio : {"0:16", "80", "80:0", "a:b", "1:2:3"})
        EXPECT_TRUE(says(complaint(least +
                                   "[stepper_x]\nrotation_distance: 40\nmicrosteps: 16\n"
                                   "gear_ratio: " +
                                   ratio),
                         "cfg:7: gear_ratio"))
            << ratio;
}

std::string limits_text(const PrinterFile& file) {
    std::string text;
    for (const NamedLimit& limit : named_limits())
        for (std::size_t axis = 0; axis < limit.count; ++axis)
            text += std::to_string(limit.get(file.printer.limits, axis)) + ' ';
    return text;
}

RC_GTEST_PROP(KlipperConfig, order_of_sections_and_of_their_lines_does_not_matter, ()) {
    std::vector<std::pair<std::string, std::vector<std::string>>> sections{
        {"[printer]\n",
         {"max_velocity: 300\n", "max_accel: 3000\n", "max_accel_to_decel: 900\n",
          "max_z_velocity: 15\n"}},
        {"[extruder]\n", {"nozzle_diameter: 0.6\n", "filament_diameter: 2.85\n"}},
        {"[stepper_x]\n", {"microsteps: 16\n", "rotation_distance: 40\n", "gear_ratio: 5:1\n"}}};
    const auto text = [&] {
        std::string all;
        for (const auto& [name, lines] : sections) {
            all += name;
            for (const std::string& line : lines) all += line;
        }
        return all;
    };
    const std::string before = limits_text(read(text()));
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    std::shuffle(sections.begin(), sections.end(), random);
    for (auto& section : sections)
        std::shuffle(section.second.begin(), section.second.end(), random);
    RC_ASSERT(limits_text(read(text())) == before);
}

RC_GTEST_PROP(KlipperConfig, any_bytes_end_in_a_printer_or_an_error, ()) {
    const auto piece = rc::gen::element<std::string>(
        "[printer]", "[include x]", "[", "]", "max_velocity", "max_accel", "gear_ratio", ":", "=",
        "\n", " ", "0", "-5", "1e999", "80:16", "nan", "[stepper_x]", "rotation_distance: 40\n",
        "microsteps:16\n", ";", "#", ",", std::string(1, '\0'), "\xEF\xBB\xBF");
    std::string text = *rc::gen::element<std::string>("", least);
    for (const std::string& word : *rc::gen::container<std::vector<std::string>>(piece))
        text += word;
    try {
        const PrinterFile file = read(text);
        for (const NamedLimit& limit : named_limits())
            for (std::size_t axis = 0; axis < limit.count; ++axis)
                RC_ASSERT(is_allowed(limit, limit.get(file.printer.limits, axis)));
    } catch (const Error&) {
    }
}

}  // namespace
}  // namespace bead
