// `beadwork vibration` as scripts call it, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/program.h"

namespace bead {
namespace {

using test::beadwork;
using test::content;
using test::Folder;
using test::Outcome;

// Rings of chords on a large machine, as arcs or as lines.
std::string rings(bool arcs) {
    std::string text = "G28\nG90\nM83\nG1 Z0.2 F600\n;LAYER_CHANGE\n;Z:0.2\n;TYPE:Perimeter\n";
    for (int k = 0; k < 3; ++k) {
        const double radius = 10 + 4 * k;
        text += "G1 X" + std::to_string(60 + radius) + " Y60 F7200\nG1 F3000\n";
        for (int i = 1; i <= 24; ++i) {
            const double x = 60 + radius * std::cos(i * 0.2617993878);
            const double y = 60 + radius * std::sin(i * 0.2617993878);
            const double x0 = 60 + radius * std::cos((i - 1) * 0.2617993878);
            const double y0 = 60 + radius * std::sin((i - 1) * 0.2617993878);
            text += (arcs ? "G3 X" : "G1 X") + std::to_string(x) + " Y" + std::to_string(y);
            if (arcs) text += " I" + std::to_string(60 - x0) + " J" + std::to_string(60 - y0);
            text += " E0.1\n";
        }
    }
    return text;
}

double vibration_number(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\": ");
    return at == json.npos ? -1 : std::stod(json.substr(at + key.size() + 4));
}

double vibration_number(const std::string& json, const std::string& object,
                        const std::string& key) {
    return vibration_number(json.substr(json.find("\"" + object + "\"")), key);
}

TEST(VibrationCommand, TellsWhatTheContractNames) {
    const Folder folder;
    const std::string file = folder.write("rings.gcode", rings(false));
    const Outcome told = beadwork("vibration " + file + " --printer ldam-1000 --json -");
    ASSERT_EQ(told.status, 0) << told.err;
    for (const char* key : {"rms_acceleration_mm_s2", "rms_5_40hz", "psd_top3", "time_s", "co2_g"})
        EXPECT_GT(vibration_number(told.out, key), 0) << key;
    const double peak = vibration_number(told.out, "peak_frequency_hz");
    EXPECT_TRUE(peak >= 5 && peak <= 40) << peak;
    for (const char* key : {"min", "mean", "max"})
        EXPECT_GE(vibration_number(told.out, "deviation_mm", key), 0) << key;
    const double mean = vibration_number(told.out, "contour_error_mm", "mean");
    const double p99 = vibration_number(told.out, "contour_error_mm", "p99");
    EXPECT_LT(mean, p99);
    EXPECT_LE(p99, vibration_number(told.out, "contour_error_mm", "max"));
    EXPECT_EQ(told.out, beadwork("vibration " + file + " --printer ldam-1000 --json -").out);
}

TEST(VibrationCommand, SetsLawsSideBySide) {
    const Folder folder;
    const std::string file = folder.write("rings.gcode", rings(false));
    const std::string csv = folder / "psd.csv", picture = folder / "psd.svg",
                      over_time = folder / "rms.svg";
    const Outcome told =
        beadwork("vibration " + file + " --printer ldam-1000 --law K0,K2,K1Mf " +
                 "--json - --csv " + csv + " --picture " + picture + " --over-time " + over_time);
    ASSERT_EQ(told.status, 0) << told.err;
    EXPECT_TRUE(content(csv).starts_with("freq_hz,K0,K2,K1Mf\n0,"));
    EXPECT_TRUE(content(picture).ends_with("</svg>\n"));
    EXPECT_NE(content(over_time).find("root mean square"), std::string::npos);
    const std::string laws = told.out.substr(told.out.find("\"laws\""));
    const std::string last = laws.substr(laws.find("K1Mf"));
    EXPECT_LT(vibration_number(last, "rms_acceleration_mm_s2"),
              0.5 * vibration_number(told.out, "rms_acceleration_mm_s2"));
}

TEST(VibrationCommand, TakesArcsAsTheFirmwareChopsThem) {
    const Folder folder;
    const std::string lines = folder.write("lines.gcode", rings(false));
    const std::string arcs = folder.write("arcs.gcode", rings(true));
    const std::string options = " --printer ldam-1000 --json -";
    const Outcome chords = beadwork("vibration " + lines + options);
    const Outcome round = beadwork("vibration " + arcs + options);
    ASSERT_EQ(round.status, 0) << round.err;
    EXPECT_NEAR(vibration_number(round.out, "time_s"), vibration_number(chords.out, "time_s"),
                0.5 * vibration_number(chords.out, "time_s"));
    EXPECT_NEAR(vibration_number(round.out, "volume_mm3"),
                vibration_number(chords.out, "volume_mm3"),
                0.02 * vibration_number(chords.out, "volume_mm3"));
    EXPECT_LT(vibration_number(round.out, "rms_acceleration_mm_s2"),
              vibration_number(chords.out, "rms_acceleration_mm_s2"));
}

TEST(VibrationCommand, RefusesWhatMakesNoSense) {
    const Folder folder;
    const std::string file = folder.write("rings.gcode", rings(false));
    const std::string dry = folder.write("dry.gcode", "G28\nG1 X50 Y50 F6000\nG1 X0 Y0\n");
    const std::string empty = folder.write("empty.gcode", "");
    const std::string zero = folder.write("zero.toml", "[vibration]\nfrequency_hz = [0, 20]\n");
    const std::string high = folder.write("high.toml", "[vibration]\nfrequency_hz = [14, 900]\n");
    const std::string less =
        folder.write("less.toml", "[vibration]\ndamping_ratio = [-0.1, 0.1]\n");
    const std::string table = folder.write("table.csv", "freq,psd_x\n1,2\n");
    struct Wrong {
        std::string arguments, words;
        int status = 3;
    };
    for (const Wrong& wrong : std::vector<Wrong>{
             {dry, "dry.gcode: no move in it lays down filament"},
             {empty, "empty.gcode"},
             {folder / "none.gcode", "none.gcode"},
             {file + " --printer " + zero, "zero.toml:2"},
             {file + " --printer " + high, "high.toml:2"},
             {file + " --printer " + less, "less.toml:2"},
             {file + " --resonances " + table, "table.csv"},
             {file + " --set vibration.frequency_hz=[0,20]", "vibration.frequency_hz", 2},
             {file + " --law K9", "K9", 2},
             {file + " --shaper soft", "soft", 2},
             {file + " --tuning 0", "--tuning", 2},
             {file + " --jerk -5", "--jerk", 2}}) {
        const Outcome outcome = beadwork("vibration " + wrong.arguments);
        EXPECT_EQ(outcome.status, wrong.status) << wrong.arguments << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(wrong.words), outcome.err.npos) << outcome.err;
    }
}

}  // namespace
}  // namespace bead
