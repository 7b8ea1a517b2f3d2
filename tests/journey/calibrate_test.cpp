// `beadwork calibrate` as users and their scripts call it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace bead {
namespace {

using nlohmann::json;
using test::beadwork;
using test::Folder;
using test::Outcome;

const std::string table3 = BEAD_SOURCE_DIR "/tests/data/somade2023/table3_calibration.csv";
const std::string head = "a_mm2_per_s2,b_mm2_per_s2,c_mm,h_s,energy_mj\n";

json json_of(const std::string& arguments) {
    const Outcome outcome = beadwork("calibrate " + arguments + " --json -");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return json::parse(outcome.out, nullptr, false);
}

const json* model_of(const json& result, const std::string& model, const std::string& fit) {
    for (const json& one : result.at("models"))
        if (one.at("model") == model && one.at("fit") == fit) return &one;
    return nullptr;
}

TEST(Calibrate, KeepsTheContractOnTableThree) {
    const json result = json_of(table3);
    EXPECT_EQ(result.at("command"), "calibrate");
    const double published[] = {0.134857071, 0.131575661, 69.14025683, 832.7358875};
    const char* names[] = {"A", "B", "C", "H"};
    for (std::size_t j = 0; j < 4; ++j) {
        const json& one = result.at("coefficients").at(j);
        EXPECT_EQ(one.at("name"), names[j]);
        EXPECT_NEAR(one.at("value").get<double>() / published[j], 1, 1e-6);
        EXPECT_GT(one.at("standard_error").get<double>(), 0);
    }
    EXPECT_NEAR(result.at("r2").get<double>(), 0.998920917, 1e-8);
    EXPECT_NEAR(result.at("r2_centred").get<double>(), 0.930, 0.0005);
    EXPECT_NEAR(result.at("loo_mape_percent").get<double>(), 5.71, 0.005);
    EXPECT_NEAR(result.at("condition_number").get<double>(), 5.98, 0.01);
    EXPECT_EQ(result.at("rows").size(), 10U);
    EXPECT_NEAR(model_of(result, "pooled", "ordinary")->at("loo_mape_percent").get<double>(), 4.68,
                0.005);
    EXPECT_LT(model_of(result, "physical", "non-negative")->at("loo_mape_percent").get<double>(),
              4.68);
    EXPECT_EQ(result.at("generalises_best").at("model"), "physical");
}

TEST(Calibrate, SameBytesForTheSameSeed) {
    const std::string call = "calibrate " + table3 + " --seed 4 --json -";
    const Outcome once = beadwork(call);
    EXPECT_EQ(once.out, beadwork(call).out);
    EXPECT_NE(once.out, beadwork("calibrate " + table3 + " --seed 5 --json -").out);
}

TEST(Calibrate, SaysWhatItTookTheFileForAndWhichModelGeneralises) {
    const Folder folder;
    const Outcome outcome =
        beadwork("calibrate " + table3 + " --model best -o " + (folder / "m.toml"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    for (const char* words : {"features, by columns", "physical (non-negative) generalises best",
                              "left out one by one", "95 %"})
        EXPECT_NE(outcome.out.find(words), std::string::npos) << words;
    const std::string written = test::content(folder / "m.toml");
    EXPECT_NE(written.find("model = \"physical\""), std::string::npos) << written;
}

// Lines there and back, as many, as fast and as long as asked; from cold.
std::string gcode(int lines, int feed, double width) {
    std::ostringstream text;
    text << "G90\nM83\nM140 S60\nM190 S60\nM109 S200\nG28\nG1 Z0.2 F600\n";
    for (int i = 0; i < lines; ++i)
        text << "G1 X" << 50 + width * (i % 2) << " Y" << 50 + 0.4 * (i / 2) << " E" << width * 0.03
             << " F" << feed << "\n";
    text << "M104 S0\nM140 S0\n";
    return text.str();
}

// Energies made by the simulation itself come back as the coefficients that made them.
TEST(Calibrate, SimulatesFilesAndFindsWhatMadeTheirEnergies) {
    const Folder folder;
    std::string table = "gcode,energy_j,group\n";
    for (int i = 0; i < 5; ++i) {
        const std::string name = std::string(1, char('a' + i)).append(".gcode");
        const std::string file =
            folder.write(name, gcode(40 + 30 * i, 1200 + 900 * (i % 3), 10 + 25 * (i % 2) + 3 * i));
        const Outcome simulated = beadwork("simulate " + file + " --json -");
        const json features = json::parse(simulated.out).at("features");
        const double energy =
            2e-4 * (features.at("A").get<double>() + features.at("B").get<double>()) +
            0.05 * features.at("C").get<double>() + 0.7 * features.at("H").get<double>();
        table += name + "," + std::to_string(energy) + "," + (i < 2 ? "small" : "large") + "\n";
    }
    const json result = json_of(folder.write("prints.csv", table) + " --model pooled");
    const double expected[] = {0.2, 50, 700};
    for (std::size_t j = 0; j < 3; ++j)
        EXPECT_NEAR(result.at("coefficients").at(j).at("value").get<double>() / expected[j], 1,
                    1e-3);
    EXPECT_NE(model_of(result, "time", "non-negative"), nullptr);
    EXPECT_EQ(result.at("groups"), 2);
}

std::string job(int id, double hours, double metres, double watt_hours,
                const std::string& status = "completed") {
    const json energy = {
        {"provider", "sensor plug"}, {"name", "energy"}, {"value", watt_hours}, {"units", "Wh"}};
    constexpr std::array files{"p0.gcode", "p1.gcode", "p2.gcode"};
    const char* const file = files[std::size_t(id) % files.size()];
    const json one = {{"job_id", std::to_string(id)},
                      {"filename", file},
                      {"status", status},
                      {"print_duration", hours * 3600},
                      {"filament_used", metres * 1000},
                      {"auxiliary_data", json::array({energy})}};
    return one.dump();
}

// 70 W, 15 Wh to heat up, 0.5 Wh a metre of filament.
TEST(Calibrate, FindsAMachinesPowerInAHistory) {
    const Folder folder;
    std::string jobs;
    for (int i = 0; i < 8; ++i) {
        const double hours = 1 + 0.7 * i, metres = 3 + 11 * (i * 5 % 8);
        jobs += job(i, hours, metres, 70 * hours + 15 + 0.5 * metres) + ",";
    }
    jobs += job(9, 1, 1, 5, "cancelled");
    const std::string file = folder.write("h.json", R"({"result": {"jobs": [)" + jobs + "]}}");
    const json result = json_of(file);
    EXPECT_EQ(result.at("scope"), "machine");
    EXPECT_EQ(result.at("model"), "machine");
    EXPECT_EQ(result.at("source").at("skipped").at("cancelled"), 1);
    EXPECT_NEAR(result.at("coefficients").at(0).at("value").get<double>(), 70, 0.01);
    EXPECT_NEAR(result.at("coefficients").at(1).at("value").get<double>(), 15 * 3600, 10);
    const double grams = 1000 * std::acos(-1.0) / 4 * 1.75 * 1.75 * 1.24e-3;
    EXPECT_NEAR(result.at("coefficients").at(2).at("value").get<double>(), 1800 / grams, 1);
    EXPECT_LT(result.at("logo_mape_percent").get<double>(), 0.1);

    for (const char* name : {"p0.gcode", "p1.gcode", "p2.gcode"})
        static_cast<void>(folder.write(name, gcode(60, 3000, 60)));
    const json simulated = json_of(file + " --gcode-folder " + (folder / ""));
    EXPECT_EQ(simulated.at("source").at("gcode_found"), 8);
    EXPECT_NE(model_of(simulated, "scaled", "ordinary"), nullptr);
}

std::string log_of(double seconds, double drift, double gap_from, double gap_to) {
    std::ostringstream text;
    text << "time,W\n";
    for (double t = 0; t < 600 + seconds; t += 2) {
        const bool on = t > 300 && t < 300 + seconds;
        if (t <= gap_from || t >= gap_to) text << t * drift << "," << (on ? "70" : "8") << "\n";
    }
    return text.str();
}

TEST(Calibrate, LaysAPowerLogBesideItsPrint) {
    const Folder folder;
    const std::string part = folder.write("part.gcode", gcode(900, 3000, 60));
    const std::string call = " --gcode " + part;
    const auto log = [&](double drift, double gap_from, double gap_to) {
        const Outcome energy = beadwork("energy " + part + " --json -");
        const json told = json::parse(energy.out);
        const double seconds =
            told.at("print_s").get<double>() + told.at("heat_up_s").get<double>();
        return folder.write("log.csv", log_of(seconds, drift, gap_from, gap_to));
    };
    const json clean = json_of("--power-log " + log(1, 0, 0) + call);
    EXPECT_EQ(clean.at("model"), "running");
    EXPECT_NEAR(clean.at("source").at("clock_scale").get<double>(), 1, 0.003);
    EXPECT_NEAR(clean.at("source").at("recorded_percent").get<double>(), 100, 1e-6);
    EXPECT_NEAR(clean.at("source").at("from_s").get<double>(), 300, 2);
    EXPECT_NEAR(clean.at("rows").at(3).at("energy_j").get<double>() /
                    clean.at("rows").at(4).at("energy_j").get<double>(),
                1, 1e-9);

    const std::string late = log(1.05, 0, 0);
    const Outcome drift = beadwork("calibrate --power-log " + late + call);
    EXPECT_EQ(drift.status, 0);
    EXPECT_NE(drift.err.find("1.04"), std::string::npos) << drift.err;
    EXPECT_NE(drift.err.find("clock drift"), std::string::npos) << drift.err;

    const std::string holed = log(1, 700, 900);
    const Outcome gap = beadwork("calibrate --power-log " + holed + call);
    EXPECT_NE(gap.err.find("1 gap in the log"), std::string::npos) << gap.err;
    const json gaps = json_of("--power-log " + holed + call).at("source");
    EXPECT_EQ(gaps.at("gaps").size(), 1U);
    EXPECT_NEAR(
        gaps.at("recorded_percent").get<double>() + gaps.at("unknown_percent").get<double>(), 100,
        1e-9);
    EXPECT_NEAR(clean.at("source").at("recorded_energy_j").get<double>() -
                    gaps.at("recorded_energy_j").get<double>(),
                70 * 202, 300);
}

struct BadCalibration {
    std::string table;
    std::string options;
    int status;
    const char* words;
};

TEST(Calibrate, RefusesInOneLine) {
    const std::string rows = head + "1e6,2e6,2e4,300,3e6\n2e6,1e6,2e4,500,3e6\n";
    std::string alike = head, still = head;
    for (int i = 1; i < 7; ++i) {
        const std::string a = std::to_string(i * i * 1000),
                          c = std::to_string(7000 + 900 * (i % 4));
        alike += a + "," + a + "," + c + "," + std::to_string(100 * (i % 3)) + ",1e6\n";
        still += a + "," + c + "," + c + ",0,1e6\n";
    }
    const BadCalibration calls[] = {
        {rows, "", 5, "2 prints cannot determine 4 coefficients; measure at least 2 more"},
        {alike, "", 5, "A (speed changes along X) and B"},
        {still, "--model pooled", 5, "is 0 in every print"},
        {rows + "1,2,3,4,-5\n", "", 3, ":4: energy_mj is -5"},
        {rows + "1,,3,4,5\n", "", 3, ":4: b_mm2_per_s2 is empty"},
        {rows + "1,1e300,3,4,5\n", "", 3, "1e300"},
        {"c_mm,h_s,energy_mj\n1,2,3\n", "", 3, "no column a_mm2_per_s2"},
        {"gcode,energy_mj\nnone.gcode,5\n", "", 3, ":2: "},
        {rows, "--scope machine", 3, "duration_s"},
        {rows, "--model machine", 2, "--model machine"},
        {rows, "--power-log x.csv --gcode y", 2, "either"},
        {"{]", "", 3, "JSON"},
        {"{}", "", 3, "jobs"},
        {rows, "--fit wild", 2, "wild"},
        {rows, "--acceleration 0", 2, "acceleration"},
    };
    for (const BadCalibration& call : calls) {
        const Folder folder;
        const Outcome outcome = beadwork("calibrate " + folder.write("t.csv", call.table) + " " +
                                         call.options + " -o " + (folder / "out.toml"));
        EXPECT_EQ(outcome.status, call.status) << call.options << call.table << outcome.err;
        EXPECT_NE(outcome.err.find(call.words), std::string::npos) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_EQ(folder.files(), 1U) << outcome.err;
    }
    EXPECT_EQ(beadwork("calibrate").status, 2);
    EXPECT_EQ(beadwork("calibrate --power-log x.csv").status, 2);
    EXPECT_EQ(beadwork("calibrate none.csv").status, 3);
}

TEST(Calibrate, NamesARowThatCannotBeRightAndKeepsIt) {
    const Folder folder;
    std::string table = test::content(table3);
    const std::size_t place = table.find("2178449.241");
    ASSERT_NE(place, std::string::npos);
    table.erase(place + 7, 1);  // the decimal point
    const Outcome outcome = beadwork("calibrate " + folder.write("t.csv", table) + " --json -");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.err.find("t.csv:7: its energy is"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), ':') > 0, true);
    EXPECT_EQ(json::parse(outcome.out).at("rows").size(), 10U);
    EXPECT_EQ(json::parse(outcome.out).at("warnings").size(), 1U);
}

}  // namespace
}  // namespace bead
