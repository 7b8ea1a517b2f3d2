// Parts through the whole program: model in, G-code out, judged again from the file.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.h"

namespace bead {
namespace {

using nlohmann::json;
using test::beadwork;
using test::Folder;

const std::string parts = BEAD_SOURCE_DIR "/examples/parts/";

json result_of(const std::string& arguments) {
    const test::Outcome outcome = beadwork(arguments + " --json -");
    EXPECT_EQ(outcome.status, 0) << arguments << ": " << outcome.err;
    return json::parse(outcome.out, nullptr, false);
}

TEST(WholeWay, WhatIsWrittenIsWhatWasSimulated) {
    for (const std::string name : {"square", "triangle", "oval"}) {
        const Folder folder;
        const std::string gcode = folder / "part.gcode";
        const json sliced = result_of("slice " + parts + name + ".stl -o " + gcode);
        const json simulated = result_of("simulate " + gcode);
        EXPECT_NEAR(double(simulated["time_s"]), double(sliced["time_s"]),
                    1e-6 * double(sliced["time_s"]));
        EXPECT_NEAR(double(simulated["extruded_mm"]), double(sliced["filament_mm"]), 1e-3);
        const json energy = result_of("energy " + gcode);
        EXPECT_NEAR(double(energy["machine_energy_j"]), double(sliced["machine_energy_j"]),
                    1e-6 * double(sliced["machine_energy_j"]));
    }
}

TEST(SlowWay, TheChoiceIsNeverWorseThanItsBaseline) {
    const std::vector<std::pair<std::string, std::string>> goals{
        {"machine-energy", "machine_energy_j"},
        {"xy-energy", "xy_motor_energy_standing_j"},
        {"time", "time_s"}};
    for (const auto& [goal, key] : goals)
        for (const std::string name : {"rectangle", "bracket"}) {
            const Folder folder;
            const std::string told = folder / "told.gcode", best = folder / "best.gcode";
            const json result = result_of("optimize " + parts + name +
                                          ".stl --layer-height 0.3 --angle-step 45 -o " + best +
                                          " --baseline " + told + " --minimize " + goal);
            const json before = result_of("energy " + told), after = result_of("energy " + best);
            EXPECT_LE(double(after[key]), double(before[key])) << name << " " << goal;
            EXPECT_NEAR(double(result["chosen"][key]), double(after[key]),
                        1e-6 * double(after[key]));
            EXPECT_NEAR(double(result["baseline"][key]), double(before[key]),
                        1e-6 * double(before[key]));
        }
}

TEST(WholeWay, TheBaselineIsWhatSliceMakes) {
    const Folder folder;
    const std::string part = parts + "triangle.stl";
    ASSERT_EQ(beadwork("slice " + part + " -o " + (folder / "a.gcode")).status, 0);
    ASSERT_EQ(beadwork("optimize " + part + " --angle-step 45 -o " + (folder / "b.gcode") +
                       " --baseline " + (folder / "c.gcode"))
                  .status,
              0);
    const auto moves = [](const std::string& text) { return text.substr(text.find("\nG28")); };
    EXPECT_EQ(moves(test::content(folder / "a.gcode")), moves(test::content(folder / "c.gcode")));
}

TEST(SlowWay, SameBytesForAnyNumberOfThreads) {
    const Folder folder;
    for (const std::string threads : {"1", "2", "5"})
        ASSERT_EQ(
            beadwork("optimize " + parts + "bracket.stl --layer-height 0.4 --angle-step 45 -o " +
                     (folder / ("t" + threads)) + " --picture " + (folder / ("p" + threads)) +
                     " --threads " + threads)
                .status,
            0);
    EXPECT_EQ(test::content(folder / "t1"), test::content(folder / "t2"));
    EXPECT_EQ(test::content(folder / "t1"), test::content(folder / "t5"));
    EXPECT_EQ(test::content(folder / "p1"), test::content(folder / "p5"));
    EXPECT_GT(test::content(folder / "t1").size(), 1000U);
}

TEST(WholeWay, AbsoluteAndRelativeExtrusionAreTheSamePrint) {
    const Folder folder;
    const std::string part = "slice " + parts + "teardrop.stl -o ";
    const json relative = result_of(part + (folder / "r.gcode"));
    const json absolute = result_of(part + (folder / "a.gcode") + " --set relative_e=false");
    EXPECT_EQ(relative["time_s"], absolute["time_s"]);
    const json back = result_of("simulate " + (folder / "a.gcode"));
    EXPECT_NEAR(double(back["time_s"]), double(relative["time_s"]),
                1e-6 * double(relative["time_s"]));
}

TEST(SlowWay, DepositsWhatWasAskedFor) {
    for (const std::string pattern :
         {"rectilinear", "concentric", "hilbert", "archimedean", "octagram"})
        for (const std::string density : {"15%", "40%", "100%"}) {
            const Folder folder;
            const json result =
                result_of("slice " + parts + "bracket.stl -o " + (folder / "a.gcode") +
                          " --pattern " + pattern + " --density " + density);
            double asked = 0, laid = 0;
            for (const std::string what : {"wall", "skin", "infill"}) {
                asked += double(result["asked_volume_mm3"][what]);
                laid += double(result["volume_mm3"][what]);
            }
            EXPECT_NEAR(laid, asked, 0.03 * asked) << pattern << " " << density;
        }
}

TEST(WholeWay, StandardOutputCarriesOnlyJson) {
    const Folder folder;
    const test::Outcome outcome =
        beadwork("slice " + parts + "square.stl -o " + (folder / "a.gcode") + " --json -");
    EXPECT_EQ(outcome.out.front(), '{');
    EXPECT_FALSE(json::parse(outcome.out, nullptr, false).is_discarded());
    const test::Outcome quiet =
        beadwork("slice " + parts + "square.stl --quiet -o " + (folder / "b.gcode"));
    EXPECT_EQ(quiet.out + quiet.err, "");
}

}  // namespace
}  // namespace bead
