// `beadwork energy` as scripts call it: modes, the power curve, tariffs, and what it refuses.
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "support/program.h"

namespace bead {
namespace {

using test::beadwork;
using test::content;
using test::Folder;
using test::Outcome;

const std::string print =
    "M140 S60\nM104 S200\nM190 S60\nM109 S200\nG28\nG1 Z0.2 F600\n;LAYER_CHANGE\n;Z:0.2\n"
    ";TYPE:Internal infill\nG1 X50 Y50 F6000\nG1 X90 Y50 E2 F2400\nG1 X90 Y51 E2.1\n"
    "G1 X50 Y51 E4.1\nG4 P1500\nG1 X50 Y90 E6\n";

// The number behind the first `"key": `.
double number(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\": ");
    return at == json.npos ? -1 : std::stod(json.substr(at + key.size() + 4));
}

struct Table {
    std::string head;
    double energy = 0;  // J, of its second column
    std::size_t rows = 0;
    std::string last;
};

Table table(const std::string& file, double step) {
    std::istringstream text(content(file));
    Table table;
    std::getline(text, table.head);
    for (std::string row; std::getline(text, row); ++table.rows) {
        table.energy += step * std::stod(row.substr(row.find(',') + 1));
        table.last = row;
    }
    return table;
}

TEST(EnergyCommand, TellsTheSameByAnyWay) {
    const Folder folder;
    const std::string file = folder.write("print.gcode", print), csv = folder / "curve.csv";
    for (const std::string mode : {"physics", "published", "corrected"}) {
        const Outcome told =
            beadwork("energy " + file + " --mode " + mode + " --explain --json - " + "--csv " +
                     csv + " --step 0.5 --tariff 0.3");
        ASSERT_EQ(told.status, 0) << told.err;
        EXPECT_NE(told.out.find("\"mode\": \"" + mode + "\""), told.out.npos);
        EXPECT_NE(told.err.find(mode + ": "), told.err.npos);
        const double joules = number(told.out, "energy_j");
        EXPECT_GT(joules, 0);
        const Table curve = table(csv, 0.5);
        EXPECT_NEAR(curve.energy, joules, 1e-6 * joules) << mode;
        EXPECT_TRUE(curve.last.ends_with("," + mode)) << curve.last;
        const std::string cost = told.out.substr(told.out.find("\"cost\""));
        EXPECT_NEAR(number(cost, "total"), 0.3 * joules / 3.6e6, 1e-9) << mode;
    }
}

TEST(EnergyCommand, NeverMixesModes) {
    const Folder folder;
    const std::string file = folder.write("print.gcode", print);
    const Outcome published = beadwork("energy " + file + " --mode published --json -");
    EXPECT_EQ(published.out.find("machine_energy_j"), published.out.npos);
    EXPECT_NE(published.out.find("xy_motor_energy_j"), published.out.npos);
    EXPECT_EQ(published.err.find("hot end"), published.err.npos);
}

TEST(EnergyCommand, TakesTheGridsCarbonAndTheHourOfTheDay) {
    const Folder folder;
    const std::string file = folder.write("print.gcode", print);
    const Outcome told = beadwork("energy " + file + " --grid-co2 1000 --json - --tariff " +
                                  "00:00-06:00=0.10,06:00-24:00=0.40 --start 05:59");
    ASSERT_EQ(told.status, 0) << told.err;
    EXPECT_NEAR(number(told.out, "co2_g"), number(told.out, "energy_j") / 3600, 1e-6);
    const std::string cost = told.out.substr(told.out.find("\"cost\""));
    const double kwh = number(told.out, "energy_j") / 3.6e6, price = number(cost, "total");
    EXPECT_TRUE(price > 0.11 * kwh && price < 0.39 * kwh) << price / kwh;
    EXPECT_NEAR(number(cost, "heat_up") + number(cost, "print"), price, 1e-12);
}

TEST(EnergyCommand, DrawsItsCurve) {
    const Folder folder;
    const std::string file = folder.write("print.gcode", print);
    EXPECT_EQ(beadwork("energy " + file + " --picture " + (folder / "curve.svg")).status, 0);
    EXPECT_TRUE(content(folder / "curve.svg").ends_with("</svg>\n"));
}

TEST(EnergyCommand, RefusesWhatMakesNoSense) {
    const Folder folder;
    const std::string file = folder.write("print.gcode", print);
    const std::string gap = folder.write("gap.toml", "[price_per_kwh]\n\"00:00-06:00\" = 0.1\n");
    const std::string word =
        folder.write("word.toml", "[price_per_kwh]\n\"00:00-24:00\" = \"x\"\n");
    struct Wrong {
        std::string options, words;
        int status = 2;
    };
    for (const Wrong& wrong : std::vector<Wrong>{
             {"--mode better", "better"},
             {"--grid-co2 -3", "--grid-co2: -3"},
             {"--grid-co2 nan", "--grid-co2: nan"},
             {"--tariff free", "free is no tariff"},
             {"--tariff 00:00-06:00=0.12 --start 10:00", "06:00 to 24:00 has no price"},
             {"--tariff 00:00-06:00=0.12,06:00-24:00=0.3", "--start"},
             {"--tariff 0.3 --start 25:00", "25:00 is no time of day"},
             {"--start 10:00", "only with --tariff"},
             {"--step 2", "only with --csv"},
             {"--csv " + (folder / "c.csv") + " --step 0", "--step: 0"},
             {"--tariff " + gap + " --start 1:00", "gap.toml: 06:00 to 24:00", 3},
             {"--tariff " + word, "word.toml:2", 3},
             {"--tariff " + (folder / "none.toml"), "none.toml", 3},
             {"--csv " + (folder / "no/such/c.csv"), "no/such", 1}}) {
        const Outcome outcome = beadwork("energy " + file + " " + wrong.options);
        EXPECT_EQ(outcome.status, wrong.status) << wrong.options << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(wrong.words), outcome.err.npos) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "c.csv"));
    }
}

}  // namespace
}  // namespace bead
