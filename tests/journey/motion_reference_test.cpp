// Our planner against blocks that the real firmware planned (tests/data/motion/README.md).
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "gcode/reader.h"
#include "support/planned.h"

namespace bead {
namespace {

using test::total_time;

const std::string folder = BEAD_SOURCE_DIR "/tests/data/motion/";

struct Case {
    std::string name, setting, lookahead;
    double time = 0;
    std::size_t blocks = 0;
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

Limits limits_of(const std::string& setting) {
    Limits limits;
    if (setting == "B") {
        limits.max_feedrate = {200, 180, 12, 120};
        limits.max_acceleration = {1250, 1000, 200, 5000};
        limits.retract_acceleration = 1000;
        limits.travel_acceleration = 1500;
        limits.jerk = {10, 8, 0.4, 1.5};
    }
    return limits;
}

std::vector<Block> planned(const Case& c, const PrusaQuirks& quirks) {
    return test::planned(limits_of(c.setting), {quirks, c.lookahead == "16" ? 16 : 0},
                         [&](const CommandSink& sink) {
                             read_gcode(std::filesystem::path(folder + c.name + ".gcode"), sink);
                         });
}

TEST(MotionReference, TotalTimesAreTheFirmwares) {
    ASSERT_GE(cases().size(), 26U);
    for (const Case& c : cases()) {
        const std::vector<Block> blocks = planned(c, faithful_quirks());
        EXPECT_EQ(blocks.size(), c.blocks) << c.name;
        EXPECT_NEAR(total_time(blocks), c.time, 1e-5 * c.time)
            << c.name << " " << c.setting << " " << c.lookahead;
    }
}

TEST(MotionReference, EverySpeedIsTheFirmwares) {
    for (const Case& c : cases()) {
        const std::vector<Block> blocks = planned(c, faithful_quirks());
        std::ifstream file(folder + c.name + "__" + c.lookahead + "_" + c.setting + ".csv");
        std::string row;
        std::getline(file, row);
        for (const Block& block : blocks) {
            ASSERT_TRUE(std::getline(file, row)) << c.name;
            const auto f = fields(row);
            EXPECT_EQ(block.line, std::stol(f[0])) << c.name;
            EXPECT_NEAR(block.v_entry, std::stod(f[1]), 1e-3) << c.name << " line " << block.line;
            EXPECT_NEAR(block.v_peak, std::stod(f[2]), 1e-3) << c.name << " line " << block.line;
            EXPECT_NEAR(block.v_exit, std::stod(f[3]), 1e-3) << c.name << " line " << block.line;
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
        EXPECT_NEAR(total_time(planned({name, "A", "unlimited"}, corrected_quirks())), time,
                    1e-5 * time)
            << name;
}

}  // namespace
}  // namespace bead
