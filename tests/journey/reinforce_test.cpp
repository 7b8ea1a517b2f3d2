// `reinforce` and `strength`: from CASE.toml to G-code and to its test.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace bead {
namespace {

using nlohmann::json;
using test::beadwork;
using test::Folder;

const std::string beam = R"(
title = "small beam"
thickness_mm = 6
outline = [[0, 0], [40, 0], [40, 12], [0, 12]]
[material]
young_mpa = 2200
poisson = 0.35
tensile_mpa = 35
compressive_mpa = 52
density_g_cm3 = 1.04
[[support]]
from = [0, 0]
to = [0, 12]
[[load]]
from = [40, 0]
to = [40, 12]
force_n = [0, -20]
[print]
fill = 0.45
)";

std::string changed(const std::string& from, const std::string& to) {
    std::string text = beam;
    return text.replace(text.find(from), from.size(), to);
}

json parsed(const std::string& file) { return json::parse(test::content(file), nullptr, false); }

void expect_no_warning(const std::string& gcode) {
    const test::Outcome run = beadwork("simulate " + gcode + " --json -");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err.find("warning"), std::string::npos) << run.err;
}

TEST(Reinforce, WritesAPrintThatWeighsWhatWasAsked) {
    const Folder folder;
    const std::string gcode = folder / "beam.gcode";
    const test::Outcome run =
        beadwork("reinforce " + folder.write("beam.toml", beam) + " --seeds 1 --only-lines -o " +
                 gcode + " --picture " + (folder / "beam.svg") + " --json " + (folder / "a.json"));
    ASSERT_EQ(run.status, 0) << run.err;
    const json result = parsed(folder / "a.json");
    EXPECT_NEAR(result["fill"], 0.45, 0.005 * 0.45);
    EXPECT_EQ(result["layers"], 10);
    EXPECT_NE(test::content(folder / "beam.svg").find("</svg>"), std::string::npos);
    expect_no_warning(gcode);

    const test::Outcome tested = beadwork("strength " + (folder / "beam.toml") + " " + gcode +
                                          " --no-baselines --json " + (folder / "b.json"));
    ASSERT_EQ(tested.status, 0) << tested.err;
    const json design = parsed(folder / "b.json")["designs"][0];
    const json best = result["designs"][0];
    EXPECT_NEAR(design["failure_load_n"].get<double>(), best["failure_load_n"].get<double>(),
                0.05 * best["failure_load_n"].get<double>());
    EXPECT_NEAR(design["mass_g"].get<double>(), best["mass_g"].get<double>(),
                0.005 * best["mass_g"].get<double>());
}

TEST(Reinforce, InThesisModeHasItsTemperatures) {
    const Folder folder;
    const std::string toml = folder.write("beam.toml", beam), gcode = folder / "a.gcode";
    for (const std::string seeds : {"edges", "even --copies 0", "stress"}) {
        const test::Outcome run = beadwork("reinforce " + toml + " --mode thesis --line-seeds " +
                                           seeds + " --hotend 250 --bed 95 --speed 30 -o " + gcode +
                                           " --json " + (folder / "a.json"));
        ASSERT_EQ(run.status, 0) << run.err;
        EXPECT_NEAR(parsed(folder / "a.json")["fill"], 0.45, 0.005 * 0.45) << seeds;
        const std::string text = test::content(gcode);
        EXPECT_NE(text.find("M109 S250"), std::string::npos);
        EXPECT_NE(text.find("M190 S95"), std::string::npos);
        EXPECT_NE(text.find("F1800"), std::string::npos);
        expect_no_warning(gcode);
    }
    const test::Outcome again = beadwork("reinforce " + toml +
                                         " --mode thesis --line-seeds stress --hotend 250 --bed 95 "
                                         "--speed 30 -o " +
                                         (folder / "b.gcode"));
    EXPECT_EQ(again.status, 0);
    EXPECT_EQ(test::content(folder / "b.gcode"), test::content(gcode));
}

// With M82 the file tells as much filament as with M83, and the same test of it.
TEST(Reinforce, CountsFilamentAsAsked) {
    const Folder folder;
    const std::string toml = folder.write("beam.toml", beam);
    std::vector<double> filament;
    for (const std::string more : {"", " --absolute-e"}) {
        const std::string gcode = folder / "a.gcode";
        const test::Outcome run =
            beadwork("reinforce " + toml + " --mode thesis -o " + gcode + more);
        ASSERT_EQ(run.status, 0) << run.err;
        const std::string text = test::content(gcode);
        EXPECT_EQ(text.find("\nM82\n") != std::string::npos, !more.empty());
        EXPECT_EQ(text.find("\nM83\n") != std::string::npos, more.empty());
        const test::Outcome told = beadwork("simulate " + gcode + " --json -");
        ASSERT_EQ(told.status, 0) << told.err;
        filament.push_back(json::parse(told.out)["extruded_mm"]);
    }
    EXPECT_NEAR(filament[0], filament[1], 1e-3 * filament[0]);
}

// Thinned crossings are read back as they were laid: the file weighs what the case asks for.
TEST(Reinforce, LaysLessWhereBeadsCross) {
    const Folder folder;
    const std::string toml = folder.write("beam.toml", beam), gcode = folder / "a.gcode";
    const test::Outcome run =
        beadwork("reinforce " + toml + " --mode thesis --line-seeds even --crossing-flow 0.5 -o " +
                 gcode + " --json " + (folder / "a.json"));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(parsed(folder / "a.json")["fill"], 0.45, 0.005 * 0.45);
    const test::Outcome tested = beadwork("strength " + toml + " " + gcode +
                                          " --no-baselines --json " + (folder / "b.json"));
    ASSERT_EQ(tested.status, 0) << tested.err;
    const double volume = parsed(folder / "b.json")["designs"][0]["volume_mm3"];
    EXPECT_NEAR(volume, 0.45 * 40 * 12 * 6, 0.006 * 0.45 * 40 * 12 * 6);
}

// What is sintered is printed larger: the file's part by the factor, its test the designed part's.
TEST(Reinforce, PrintsMetalLarger) {
    const Folder folder;
    const std::string toml =
        folder.write("beam.toml", changed("density_g_cm3 = 1.04",
                                          "density_g_cm3 = 7.7\ngreen_scale_plane = 1.2\n"
                                          "green_scale_height = 1.25"));
    const std::string gcode = folder / "a.gcode";
    const test::Outcome run = beadwork("reinforce " + toml + " --mode thesis -o " + gcode +
                                       " --json " + (folder / "a.json"));
    ASSERT_EQ(run.status, 0) << run.err;
    // 6 mm of 0.6 / 1.25 mm layers.
    EXPECT_EQ(parsed(folder / "a.json")["layers"], 13);
    const test::Outcome tested = beadwork("strength " + toml + " " + gcode +
                                          " --no-baselines --json " + (folder / "b.json"));
    ASSERT_EQ(tested.status, 0) << tested.err;
    const json design = parsed(folder / "b.json")["designs"][0];
    EXPECT_NEAR(design["volume_mm3"].get<double>(), 0.45 * 40 * 12 * 6, 0.01 * 0.45 * 40 * 12 * 6);
}

TEST(Strength, ComparesWithSlicersAtTheSameWeight) {
    const Folder folder;
    const test::Outcome run = beadwork("strength " + folder.write("beam.toml", beam) +
                                       " --phases 1 --pixel 0.2 --json " + (folder / "a.json"));
    ASSERT_EQ(run.status, 0) << run.err;
    const json designs = parsed(folder / "a.json")["designs"];
    EXPECT_GE(designs.size(), 8U);
    for (const json& design : designs) {
        EXPECT_NEAR(design["volume_mm3"].get<double>(), 0.45 * 40 * 12 * 6, 0.006 * 1296);
        EXPECT_TRUE(design["baseline"]);
    }
}

std::string sliced(const std::string& name) {
    return std::string(BEAD_SOURCE_DIR) + "/tests/data/strength/beam_by_" + name + ".gcode";
}

std::string thin_beam(const Folder& folder, const std::string& size = "40") {
    std::string text = changed("thickness_mm = 6", "thickness_mm = 1.2\nguided = true");
    for (std::size_t at = text.find("40,"); at != std::string::npos; at = text.find("40,", at + 1))
        text.replace(at, 2, size);
    return folder.write("thin" + size + ".toml", text);
}

// The same beam of 1.2 mm: by PrusaSlicer 2.5 (two layers, turned by 90 degrees, with a skirt, a
// brim and a line that primes, absolute extrusion), by CuraEngine 4.13 (four layers, a skirt).
TEST(Strength, ReadsSlicersFilesWhereverTheyStand) {
    const Folder folder;
    const test::Outcome run =
        beadwork("strength " + thin_beam(folder) + " " + sliced("prusaslicer") + " " +
                 sliced("cura") + " --no-baselines --progress json --json " + (folder / "a.json"));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(run.err.find("stands turned by 90"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("\"fraction\": 1.00"), std::string::npos) << run.err;
    const json designs = parsed(folder / "a.json")["designs"];
    const json prusa = designs[0], cura = designs[1];
    EXPECT_NEAR(prusa["place"]["turn_deg"], 90, 1e-9);
    EXPECT_NEAR(prusa["place"]["origin_mm"][0], 131, 0.02);
    EXPECT_NEAR(prusa["place"]["origin_mm"][1], 85, 0.02);
    // Walls of 101.6 mm, six rows of triangles of 5.14 mm, what joins them at the wall.
    EXPECT_NEAR(prusa["volume_mm3"], 280, 8);
    EXPECT_NEAR(cura["volume_mm3"], 277, 8);
    // The same pattern at nearly the same place: as stiff within a tenth.
    EXPECT_NEAR(cura["stiffness_n_mm"].get<double>() / prusa["stiffness_n_mm"].get<double>(), 1,
                0.1);
}

TEST(Strength, TakesFilesAsTold) {
    const Folder folder;
    const auto run = [&](const std::string& more, const std::string& size = "40") {
        return beadwork("strength " + thin_beam(folder, size) + " " + sliced("prusaslicer") +
                        " --no-baselines --pixel 0.2 " + more);
    };
    EXPECT_EQ(run("--turn 90").out, run("").out);
    EXPECT_EQ(run("--turn 270 --origin 119 125").status, 0);
    for (const test::Outcome& wrong : {run("--turn 45"), run("--origin 10 10"), run("", "44")}) {
        EXPECT_EQ(wrong.status, 3) << wrong.err;
        EXPECT_NE(wrong.err.find("is not the case's part"), std::string::npos) << wrong.err;
        EXPECT_EQ(std::count(wrong.err.begin(), wrong.err.end(), '\n'), 1) << wrong.err;
    }
    const test::Outcome high = beadwork("strength " + folder.write("beam.toml", beam) + " " +
                                        sliced("cura") + " --no-baselines");
    EXPECT_EQ(high.status, 3);
    EXPECT_NE(high.err.find("1.2 mm high together"), std::string::npos) << high.err;
    EXPECT_EQ(beadwork("strength " + (folder / "beam.toml") + " --no-baselines").status, 2);
}

TEST(Strength, ShowsOfSlicersPatternsOnlyTheBest) {
    const Folder folder;
    const std::string arguments =
        "strength " + folder.write("beam.toml", beam) + " --phases 1 --pixel 0.2 --json ";
    ASSERT_EQ(beadwork(arguments + (folder / "all.json")).status, 0);
    ASSERT_EQ(beadwork(arguments + (folder / "best.json") + " --best").status, 0);
    const json best = parsed(folder / "best.json")["designs"];
    ASSERT_EQ(best.size(), 1U);
    const json all = parsed(folder / "all.json")["designs"];
    for (const json& design : all)
        EXPECT_LE(design["strength_to_weight"], best[0]["strength_to_weight"]);
}

TEST(Stress, TellsWhenAThinPartBuckles) {
    const Folder folder;
    const std::string toml =
        folder.write("beam.toml", changed("thickness_mm = 6", "thickness_mm = 1"));
    const test::Outcome run = beadwork("stress " + toml + " --buckling --json -");
    ASSERT_EQ(run.status, 0) << run.err;
    const json result = json::parse(run.out, nullptr, false);
    EXPECT_GT(result["buckling_factor"], result["sideways_buckling_factor"]);
    EXPECT_GT(result["sideways_buckling_factor"], 0);
}

TEST(Reinforce, SaysWhatIsWrongInOneLine) {
    const Folder folder;
    const auto expect = [&](const std::string& command, const std::string& text, int status,
                            const std::string& words, const std::string& more = "") {
        const std::string toml = folder.write("x.toml", text);
        const std::string out = command == "reinforce" ? " -o " + (folder / "x.gcode") : "";
        const test::Outcome run = beadwork(command + " " + toml + out + more);
        EXPECT_EQ(run.status, status) << words << ": " << run.err;
        EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "x.gcode"));
    };
    const std::string hole = "circles = [{center = [20, 6], radius = 3}]\n[material]";
    for (const char* command : {"reinforce", "strength"}) {
        expect(command, changed("to = [0, 12]", "to = [0, 0]"), 3, "turn about a point");
        expect(command, changed("to = [0, 12]", "to = [0, 12]\nfix = \"x\""), 3, "slide along y");
        expect(command, changed("force_n = [0, -20]", "force_n = [0, 0]"), 3, "is no force");
        expect(command, changed("[40, 12], [0, 12]]", "[0, 12], [40, 12]]"), 3,
               "crosses itself at");
        expect(command, changed("fill = 0.45", "bead_width_mm = 13"), 3, "thinner than a bead");
        expect(
            command,
            [&] {
                std::string text = changed("[material]", hole);
                const std::string from = "from = [40, 0]\nto = [40, 12]";
                return text.replace(text.find(from), from.size(),
                                    "on = {center = [20, 6], radius = 3}\narc_deg = [0, 180]\n"
                                    "bearing = true");
            }(),
            3, "empty side");
        expect(command, changed("fill = 0.45", "fill = 0.02"), 4, "fill");
    }
    expect("reinforce", changed("fill = 0.45", "fill = 0.1"), 4, "fill 0.1 cannot be reached",
           " --mode thesis");
    expect("reinforce", beam, 4, "is as near as lines come",
           " --mode thesis --seed-distance 30 --copies 0");
    expect("reinforce", beam, 4, "lay lines farther apart", " --mode thesis --seed-distance 0.35");
    expect("reinforce", beam, 2, "--seed-distance 1e-06: less than half a bead",
           " --mode thesis --seed-distance 1e-6");
    expect("reinforce", beam, 2, "--mode", " --mode weakest");
    expect("reinforce", beam, 2, "--line-seeds", " --mode thesis --line-seeds corners");
    const test::Outcome none = beadwork("strength " + folder.write("x.toml", beam) + " " +
                                        (folder / "none.gcode") + " --no-baselines");
    EXPECT_EQ(none.status, 3) << none.err;
    const std::string two =
        changed("[[support]]",
                "[[case]]\n[[case.support]]\nfrom=[0,0]\nto=[0,12]\n[[case.load]]\n"
                "from=[40,0]\nto=[40,12]\nforce_n=[1,0]\n[[case]]\n[[case.support]]");
    std::string both = two;
    both.replace(both.find("[[load]]"), 8, "[[case.load]]");
    expect("reinforce", both, 3, "thesis mode lays lines for one", " --mode thesis");
}

}  // namespace
}  // namespace bead
