// Our planners against blocks that real firmware planned (tests/data/motion/README.md).
#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <map>
#include <sstream>

#include "gcode/reader.h"
#include "support/planned.h"

namespace bead {
namespace {

using test::total_time;

const std::string folder = BEAD_SOURCE_DIR "/tests/data/motion/";

struct Case {
    std::string name, planner, setting;
    double time = 0;
    std::size_t blocks = 0;
};

struct Reference {
    std::int64_t line = 0;
    double entry = 0, peak = 0, exit = 0;
};

std::vector<std::string> fields(const std::string& row) {
    std::vector<std::string> parts;
    std::istringstream text(row);
    for (std::string part; std::getline(text, part, ',');) parts.push_back(part);
    return parts;
}

std::vector<Case> cases() {
    std::vector<Case> all;
    std::ifstream file(folder + "totals.csv");
    std::string row;
    std::getline(file, row);
    while (std::getline(file, row)) {
        const auto f = fields(row);
        all.push_back({f[0], f[1], f[2], std::stod(f[3]), std::stoul(f[4])});
    }
    return all;
}

// Blocks by case.
std::map<std::string, std::vector<Reference>> blocks_of(const std::string& planner,
                                                        const std::string& setting) {
    std::map<std::string, std::vector<Reference>> blocks;
    const std::string path = folder + planner + "__" + setting + ".csv.gz";
    gzFile const file = gzopen(path.c_str(), "rb");
    std::array<char, 256> row;
    gzgets(file, row.data(), int(row.size()));
    while (gzgets(file, row.data(), int(row.size())) != nullptr) {
        const auto f = fields(row.data());
        blocks[f[0]].push_back(
            {std::stol(f[1]), std::stod(f[2]), std::stod(f[3]), std::stod(f[4])});
    }
    gzclose(file);
    return blocks;
}

double number_after(const std::string& text, const std::string& start) {
    return text.starts_with(start) ? std::stod(text.substr(start.size())) : 0;
}

Limits limits_of(const Case& c) {
    Limits limits;
    if (c.setting == "B") {
        limits.max_feedrate = {200, 180, 12, 120};
        limits.max_acceleration = {1250, 1000, 200, 5000};
        limits.retract_acceleration = limits.extrude_only_acceleration = 1000;
        limits.travel_acceleration = 1500;
        limits.jerk = {10, 8, 0.4, 1.5};
        limits.instantaneous_corner_velocity = 1.5;
    }
    limits.junction_deviation = number_after(c.planner, "marlin-jd-");
    limits.minimum_cruise_ratio = number_after(c.planner, "klipper-");
    return limits;
}

Firmware firmware_of(const Case& c) {
    for (std::size_t i = firmware_names.size(); i-- > 0;)
        if (c.planner.starts_with(firmware_names[i])) return Firmware(i);
    return Firmware::prusa;
}

std::vector<Block> planned(const Case& c, bool corrected = false) {
    const Firmware firmware = firmware_of(c);
    const int lookahead = c.planner.ends_with("unlimited") ? 0 : 16;
    return test::planned(limits_of(c), {firmware, corrected, lookahead},
                         [&](const CommandSink& sink) {
                             read_gcode(std::filesystem::path(folder + c.name + ".gcode"),
                                        {.firmware = firmware}, sink);
                         });
}

TEST(MotionReference, TotalTimesAreTheFirmwares) {
    ASSERT_EQ(cases().size(), 104U);
    for (const Case& c : cases()) {
        const std::vector<Block> blocks = planned(c);
        EXPECT_EQ(blocks.size(), c.blocks) << c.name;
        EXPECT_NEAR(total_time(blocks), c.time, 1e-5 * c.time)
            << c.name << " " << c.planner << " " << c.setting;
    }
}

TEST(MotionReference, EverySpeedIsTheFirmwares) {
    std::map<std::string, std::map<std::string, std::vector<Reference>>> read;
    for (const Case& c : cases()) {
        auto& of_planner = read[c.planner + c.setting];
        if (of_planner.empty()) of_planner = blocks_of(c.planner, c.setting);
        const std::vector<Reference>& reference = of_planner.at(c.name);
        const std::vector<Block> blocks = planned(c);
        ASSERT_EQ(blocks.size(), reference.size()) << c.name << " " << c.planner;
        for (std::size_t k = 0; k < blocks.size(); ++k) {
            const std::string where = c.name + " " + c.planner + " " + c.setting + " line " +
                                      std::to_string(reference[k].line);
            EXPECT_EQ(blocks[k].line, reference[k].line) << where;
            EXPECT_NEAR(blocks[k].v_entry, reference[k].entry, 1e-3) << where;
            EXPECT_NEAR(blocks[k].v_peak, reference[k].peak, 1e-3) << where;
            EXPECT_NEAR(blocks[k].v_exit, reference[k].exit, 1e-3) << where;
        }
    }
}

// Times of an independent implementation of the corrected rules, setting A, unlimited look-ahead.
TEST(MotionReference, CorrectedTimesAgreeWithAnIndependentImplementation) {
    const std::vector<std::pair<std::string, double>> times{
        {"c01_single_line", 1.0648},        {"c02_corner90", 4.853442},
        {"c03_zigzag", 5.510332},           {"c04_circle_tiny_chords", 3.452801},
        {"c05_mixed_feedrates", 39.204488}, {"s1_cube10_absE", 434.598608}};
    for (const auto& [name, time] : times)
        EXPECT_NEAR(total_time(planned({name, "prusa-unlimited", "A"}, true)), time, 1e-5 * time)
            << name;
}

}  // namespace
}  // namespace bead
