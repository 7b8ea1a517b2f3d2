#include "job/sourced_printer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fmt/format.h>

#include "job/printer_file.h"
#include "support/job_errors.h"
#include "support/scratch_file.h"

namespace bead {
namespace {

using test::complaint_of;
using test::says;
using test::ScratchFile;

// Limits that every source can state, one value each.
struct Common {
    const char *limit, *slicer;
};
constexpr Common commons[] = {
    {"acceleration_mm_s2", "machine_max_acceleration_extruding"},
    {"retract_acceleration_mm_s2", "machine_max_acceleration_retracting"},
    {"travel_acceleration_mm_s2", "machine_max_acceleration_travel"},
    {"junction_deviation_mm", "machine_max_junction_deviation"},
};
constexpr const char* source_names[] = {"default printer", "slicer's notes", "environment",
                                        "printer.toml", "--set"};

// By strength: value of the limit of each source, 0 where it does not state it.
RC_GTEST_PROP(SourcedPrinter, the_strongest_source_of_each_limit_wins, ()) {
    const Limits usual = load_printer(usual_printer).limits;
    std::string toml = "[limits]\n";
    PrinterSources sources;
    std::vector<std::array<double, 5>> told;
    for (const Common& common : commons) {
        std::array<double, 5> values{named_limit(common.limit).get(usual, 0)};
        for (std::size_t k = 1; k < values.size(); ++k)
            if (*rc::gen::arbitrary<bool>()) values[k] = *rc::gen::inRange(1, 100'000);
        const auto text = [&](std::size_t k) { return fmt::format("{}", values[k]); };
        if (values[1] > 0) sources.notes[common.slicer] = text(1);
        if (values[2] > 0) sources.environment[common.slicer] = text(2);
        if (values[3] > 0) toml += fmt::format("{} = {}\n", common.limit, text(3));
        if (values[4] > 0)
            sources.set.push_back(fmt::format("limits.{}={}", common.limit, text(4)));
        told.push_back(values);
    }
    const ScratchFile file("printer.toml", toml);
    if (*rc::gen::arbitrary<bool>())
        sources.printer = file.path();
    else
        for (auto& values : told) values[3] = 0;

    const SourcedPrinter sourced = sourced_printer(sources);
    for (std::size_t i = 0; i < told.size(); ++i) {
        const NamedLimit& limit = named_limit(commons[i].limit);
        std::size_t strongest = 4;
        while (told[i][strongest] == 0) --strongest;
        RC_ASSERT(limit.get(sourced.printer.limits, 0) == told[i][strongest]);
        RC_ASSERT(says(sourced.limits.source(limit), source_names[strongest]));
    }
}

TEST(SourcedPrinter, AxesOfOneLimitMayHaveDifferentSources) {
    const SourcedPrinter sourced = sourced_printer(
        {.environment = {{"machine_max_jerk_x", "9"}, {"machine_max_jerk_z", "0.2"}}});
    EXPECT_EQ(sourced.printer.limits.jerk, (std::array<double, 4>{9, 10, 0.2, 2.5}));
    EXPECT_EQ(sourced.limits.source(named_limit("jerk_mm_s")),
              "X, Z: environment (SLIC3R_MACHINE_MAX_JERK_*); Y, E: default printer prusa-mk3s");
}

TEST(SourcedPrinter, BuiltInPrintersStateTheirLimits) {
    const SourcedPrinter sourced =
        sourced_printer({.printer = "ender3", .notes = {{"machine_max_jerk_x", "99"}}});
    EXPECT_EQ(sourced.printer.limits.jerk, load_printer("ender3").limits.jerk);
    EXPECT_EQ(sourced.limits.source(named_limit("jerk_mm_s")), "built-in printer ender3");
}

TEST(SourcedPrinter, SetReachesEveryPartOfThePrinter) {
    const SourcedPrinter sourced = sourced_printer(
        {.set = {"nozzle_mm = 0.6", "limits.jerk_mm_s=[1, 2, 3, 4]", "kinematics=corexy",
                 "power.electronics_w=3", "limits.slowdown=true", "limits.acceleration_mm_s2=7",
                 "limits.acceleration_mm_s2=8"},
         .printer = "ender3"});
    EXPECT_EQ(sourced.printer.nozzle, 0.6);
    EXPECT_EQ(sourced.printer.limits.jerk, (std::array<double, 4>{1, 2, 3, 4}));
    EXPECT_EQ(sourced.printer.kinematics, Kinematics::corexy);
    EXPECT_EQ(sourced.printer.power.electronics, 3);
    EXPECT_TRUE(sourced.printer.limits.slowdown);
    EXPECT_EQ(sourced.printer.limits.acceleration, 8) << "the last one counts";
    EXPECT_EQ(sourced.printer.bed, load_printer("ender3").bed);
}

TEST(SourcedPrinter, SetOfOneThingLeavesADeltasTowersAlone) {
    const ScratchFile file("printer.toml",
                           "kinematics = \"delta\"\n[delta]\nradius_mm = 150\narm_mm = 300\n");
    const SourcedPrinter sourced =
        sourced_printer({.set = {"nozzle_mm=0.6", "delta.arm_mm=310"}, .printer = file.path()});
    EXPECT_EQ(sourced.printer.delta.radius, 150);
    EXPECT_EQ(sourced.printer.delta.arm, 310);
}

TEST(SourcedPrinter, SetRefusesWhatCannotBe) {
    for (const std::string value :
         {"0", "-5", "nan", "inf", "1e300", "1e-300", "fast", "", "[1]", "= 5"}) {
        const std::string text =
            complaint_of([&] { sourced_printer({.set = {"limits.acceleration_mm_s2=" + value}}); },
                         Fault::usage);
        EXPECT_TRUE(says(text, "--set: ")) << value << text;
    }
    const auto complaint = [](const std::string& set) {
        return complaint_of([&] { sourced_printer({.set = {set}}); }, Fault::usage);
    };
    EXPECT_TRUE(says(complaint("limits.jerk_mm_s=[8,8,0,2]"), "jerk_mm_s is 0"));
    EXPECT_TRUE(says(complaint("limits.max_jerk=8"), "is not a setting"));
    EXPECT_TRUE(says(complaint("speed"), "name=value"));
}

TEST(SourcedPrinter, FirmwareIsTheStrongestSourcesToo) {
    const SlicerSettings marlin{{"gcode_flavor", "marlin2"}};
    EXPECT_EQ(sourced_printer({}).firmware.source, "default");
    EXPECT_EQ(sourced_printer({.notes = marlin}).firmware.firmware, Firmware::marlin_jerk);
    const ScratchFile file("printer.cfg", "[printer]\nmax_velocity: 9\nmax_accel: 99\n");
    const SourcedPrinter klipper = sourced_printer({.printer = file.path(), .notes = marlin});
    EXPECT_EQ(klipper.firmware.firmware, Firmware::klipper);
    EXPECT_EQ(klipper.printer.limits.acceleration, 99);
}

}  // namespace
}  // namespace bead
