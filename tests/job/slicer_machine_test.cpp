#include "job/slicer_machine.h"

#include <gtest/gtest.h>

#include <array>

#include "support/job_errors.h"

namespace bead {
namespace {

using test::says;

Statement of_file(const SlicerSettings& settings) {
    return slicer_statement(settings, SlicerPlace::file, "notes");
}

TEST(SlicerMachine, LimitsAreThoseOfNormalMode) {
    const Statement said = of_file({{"machine_max_acceleration_x", "9000,1000"},
                                    {"machine_max_speed_y", "500,200"},
                                    {"machine_max_feedrate_z", "12"},
                                    {"machine_max_jerk_e", "2.5"},
                                    {"machine_max_acceleration_extruding", "20000,20000"},
                                    {"machine_max_junction_deviation", "0.02"}});
    ASSERT_EQ(said.limits.size(), 6U);
    const auto value = [&](std::string_view name, std::size_t axis) {
        for (const StatedLimit& limit : said.limits)
            if (limit.name == name && limit.axis == axis) return limit.value;
        return 0.0;
    };
    EXPECT_EQ(value("max_acceleration_mm_s2", 0), 9000);
    EXPECT_EQ(value("max_feedrate_mm_s", 1), 500);
    EXPECT_EQ(value("max_feedrate_mm_s", 2), 12);
    EXPECT_EQ(value("jerk_mm_s", 3), 2.5);
    EXPECT_EQ(value("acceleration_mm_s2", 0), 20000);
    EXPECT_EQ(value("junction_deviation_mm", 0), 0.02);
    EXPECT_TRUE(said.warnings.empty());
}

TEST(SlicerMachine, LimitsDoNotCountWhenTheSlicerIgnoresThem) {
    const Statement said = of_file({{"machine_max_jerk_x", "8"},
                                    {"machine_limits_usage", "ignore"},
                                    {"gcode_flavor", "klipper"}});
    EXPECT_TRUE(said.limits.empty());
    EXPECT_EQ(said.firmware->firmware, Firmware::klipper);
}

TEST(SlicerMachine, WhatIsNoLimitIsPassedOverAloud) {
    for (const char* value : {"0", "-1", "nan", "fast", "1e300", "0,5", "inf"}) {
        const Statement said = of_file({{"machine_max_jerk_x", value}});
        EXPECT_TRUE(said.limits.empty()) << value;
        ASSERT_EQ(said.warnings.size(), 1U) << value;
        EXPECT_TRUE(says(said.warnings[0], "machine_max_jerk_x")) << said.warnings[0];
    }
    const Statement none = of_file({{"machine_max_acceleration_travel", "0"},
                                    {"machine_max_junction_deviation", "0,0"},
                                    {"machine_max_jerk_x", ""}});
    EXPECT_TRUE(none.limits.empty() && none.warnings.empty()) << "zero means: not limited";
}

TEST(SlicerMachine, FlavorNamesTheFirmware) {
    struct Row {
        const char *flavor, *deviation;
        Firmware firmware;
    };
    for (const Row& row :
         {Row{"klipper", "0", Firmware::klipper}, Row{"marlin", "0", Firmware::prusa},
          Row{"marlin2", "0.01", Firmware::marlin_jd}, Row{"marlin2", "0", Firmware::marlin_jerk},
          Row{"reprapfirmware", "0", Firmware::marlin_jerk}}) {
        const Statement said = of_file(
            {{"gcode_flavor", row.flavor}, {"machine_max_junction_deviation", row.deviation}});
        ASSERT_TRUE(said.firmware) << row.flavor;
        EXPECT_EQ(said.firmware->firmware, row.firmware) << row.flavor;
        EXPECT_TRUE(says(said.firmware->source, std::string("gcode_flavor = ") + row.flavor));
    }
    EXPECT_FALSE(of_file({{"gcode_flavor", "mach3"}}).firmware);
    EXPECT_FALSE(of_file({}).firmware);
}

TEST(SlicerMachine, EnvironmentHasTheSameSettingsInCapitals) {
    const std::array<const char*, 6> variables{"PATH=/bin",
                                               "SLIC3R_MACHINE_MAX_ACCELERATION_X=9000,1000",
                                               "SLIC3R_MACHINE_MAX_JERK_Y=0",
                                               "SLIC3R_",
                                               "SLIC3R_EMPTY=",
                                               nullptr};
    const SlicerSettings settings = slicer_environment(variables.data());
    EXPECT_EQ(settings.at("machine_max_acceleration_x"), "9000,1000");
    const Statement said = slicer_statement(settings, SlicerPlace::environment, "environment");
    ASSERT_EQ(said.limits.size(), 1U);
    EXPECT_TRUE(says(said.limits[0].source, "SLIC3R_MACHINE_MAX_ACCELERATION_"));
    ASSERT_EQ(said.warnings.size(), 1U);
    EXPECT_TRUE(says(said.warnings[0], "SLIC3R_MACHINE_MAX_JERK_Y = 0"));
}

}  // namespace
}  // namespace bead
