#include "job/resonance_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "support/scratch_file.h"

namespace bead {
namespace {

using test::ScratchFile;

std::string measured(double x, double y) {
    const auto power = [](double f, double f0) {
        return 1e3 / (std::pow(1 - f * f / (f0 * f0), 2) + std::pow(0.1 * f / f0, 2));
    };
    std::string text = "freq,psd_x,psd_y,psd_z,psd_xyz,mzv(34.6)\n";
    for (double f = 0; f < 200; f += 0.5)
        text += fmt::format("{},{},{},1,2,0.1\n", f, power(f, x), power(f, y));
    return text;
}

TEST(ResonanceFile, IsReadAsKlipperWritesIt) {
    const ScratchFile file("calibration.csv", measured(47, 38));
    EXPECT_NEAR(resonance_of(file.path(), 0).frequency, 47, 0.2);
    EXPECT_NEAR(resonance_of(file.path(), 1).frequency, 38, 0.2);
    EXPECT_NEAR(resonance_of(file.path(), 1).damping, 0.05, 0.003);
}

TEST(ResonanceFile, IsRefusedWithAReason) {
    struct Wrong {
        std::string text, says;
    };
    for (const Wrong& wrong : {Wrong{"", "empty"}, Wrong{"time,x\n1,2\n", "no column freq"},
                               Wrong{"freq,psd_x\n5,1\n4,1\n", ":3: freq must grow"},
                               Wrong{"freq,psd_x\n5,1\n6,x\n", ":3: column 2"},
                               Wrong{"freq,psd_x\n5,1\n6,2\n7,3\n8,4\n9,5\n", "no clear peak"},
                               Wrong{measured(150, 38), "no clear peak"}}) {
        const ScratchFile file("wrong.csv", wrong.text);
        try {
            resonance_of(file.path(), 0);
            ADD_FAILURE() << wrong.says;
        } catch (const Error& error) {
            EXPECT_EQ(error.fault(), Fault::input);
            EXPECT_NE(std::string(error.what()).find(wrong.says), std::string::npos)
                << error.what();
        }
    }
}

}  // namespace
}  // namespace bead
