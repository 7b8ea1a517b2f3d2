#include "job/vibration_table.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "job/printer_file.h"
#include "support/scratch_file.h"
#include "vibration/drive.h"

namespace bead {
namespace {

using test::ScratchFile;

VibrationModel model_of(const std::string& text) {
    const ScratchFile file("printer.toml", text);
    return load_printer(file.path()).vibration;
}

std::string vibration_complaint(const std::string& text) {
    try {
        model_of(text);
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::input);
        return error.what();
    }
    return "none";
}

TEST(VibrationTable, TakesMeasuredModes) {
    const VibrationModel model =
        model_of("[vibration]\nfrequency_hz = [9, 13]\ndamping_ratio = [0.03, 0.05]\n");
    EXPECT_NEAR(first_mode(model.axes[0]).frequency, 9, 1e-6);
    EXPECT_NEAR(first_mode(model.axes[0]).damping, 0.03, 1e-6);
    EXPECT_NEAR(first_mode(model.axes[1]).frequency, 13, 1e-6);
    EXPECT_NEAR(first_mode(model.axes[1]).damping, 0.05, 1e-6);
}

TEST(VibrationTable, TakesMassesAndStiffnesses) {
    const VibrationModel model = model_of(
        "[vibration]\ntable_mass_kg = [10, 7]\nflexure_n_per_mm = [40, 50]\n"
        "[vibration.screw]\nsupport = \"fixed-fixed\"\ncoupling_at_mm = [-50, 20]\n");
    EXPECT_EQ(model.axes[0].table_mass, 10);
    EXPECT_EQ(model.axes[1].flexure, 50'000);
    EXPECT_EQ(model.axes[0].slave_mass, VibrationModel{}.axes[0].slave_mass);
    EXPECT_EQ(model.axes[0].screw.support, ScrewSupport::fixed_fixed);
    EXPECT_NEAR(*model.axes[0].screw.coupling_at, -0.05, 1e-12);
}

TEST(VibrationTable, EveryBuiltInPrinterHasModesOfItsOwn) {
    for (const std::string& name : printer_names())
        for (const DriveAxis& axis : load_printer(name).vibration.axes) {
            const DriveMode mode = first_mode(axis);
            EXPECT_TRUE(mode.frequency > 5 && mode.frequency < highest_mode) << name;
            EXPECT_TRUE(mode.damping > 0.01 && mode.damping < 0.2) << name;
        }
    EXPECT_NEAR(first_mode(load_printer("ldam-1000").vibration.axes[0]).frequency, 13.9, 0.05);
}

TEST(VibrationTable, IsASettingToo) {
    const Printer usual = load_printer("ldam-1000");
    const Printer set = with_setting(usual, "vibration.frequency_hz=[25, 35]").printer;
    EXPECT_NEAR(first_mode(set.vibration.axes[1]).frequency, 35, 1e-6);
    EXPECT_EQ(set.vibration.axes[0].table_mass, usual.vibration.axes[0].table_mass);
}

TEST(VibrationTable, RefusesWhatCannotBe) {
    struct Wrong {
        const char *text, *says;
    };
    for (const Wrong& wrong : {
             Wrong{"frequency_hz = [0, 20]", "printer.toml:2: vibration.frequency_hz"},
             Wrong{"frequency_hz = [20, 101]", "at most 100"},
             Wrong{"frequency_hz = [-3, 20]", "vibration.frequency_hz"},
             Wrong{"frequency_hz = [20]", "array of 2 numbers"},
             Wrong{"damping_ratio = [-0.1, 0.1]", "vibration.damping_ratio"},
             Wrong{"damping_ratio = [0.7, 0.1]", "vibration.damping_ratio"},
             Wrong{"flexure_n_per_mm = [1e7, 100]", "at most 100 Hz"},
             Wrong{"table_mass_kg = [0, 1]", "vibration.table_mass_kg"},
             Wrong{"screw.nut_distance_mm = [2000, 400]", "beyond its screw"},
             Wrong{"screw.support = \"glued\"", "fixed-free"},
             Wrong{"frequenz = [1, 2]", "is not a key"},
         }) {
        const std::string words =
            vibration_complaint(std::string("[vibration]\n") + wrong.text + "\n");
        EXPECT_NE(words.find(wrong.says), words.npos) << wrong.text << ": " << words;
        EXPECT_EQ(words.find('\n'), words.npos);
    }
}

}  // namespace
}  // namespace bead
