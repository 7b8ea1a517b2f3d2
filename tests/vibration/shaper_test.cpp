#include "vibration/shaper.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

namespace bead {
namespace {

constexpr std::array kinds{ShaperKind::zv, ShaperKind::mzv,         ShaperKind::zvd,
                           ShaperKind::ei, ShaperKind::two_hump_ei, ShaperKind::three_hump_ei};

RC_GTEST_PROP(Shaper, ChangesNeitherPlaceNorMeanTime, ()) {
    const double frequency = *rc::gen::inRange(50, 1000) / 10.0;
    const double damping = *rc::gen::inRange(0, 300) / 1000.0;
    for (const ShaperKind kind : kinds) {
        double sum = 0, mean = 0;
        for (const Pulse& pulse : shaper(kind, frequency, damping)) {
            sum += pulse.weight;
            mean += pulse.weight * pulse.delay;
            RC_ASSERT(pulse.weight > 0);
        }
        RC_ASSERT(std::abs(sum - 1) < 1e-12);
        RC_ASSERT(std::abs(mean) < 1e-12);
    }
}

TEST(Shaper, LeavesNoVibrationOfItsMode) {
    for (const double damping : {0.0, 0.04, 0.1}) {
        for (const ShaperKind kind : {ShaperKind::zv, ShaperKind::zvd})
            EXPECT_LT(residual_vibration(shaper(kind, 14, damping), 14, damping), 1e-12);
        EXPECT_LT(residual_vibration(shaper(ShaperKind::mzv, 14, damping), 14, damping), 0.01);
        for (const ShaperKind kind :
             {ShaperKind::ei, ShaperKind::two_hump_ei, ShaperKind::three_hump_ei})
            EXPECT_LT(residual_vibration(shaper(kind, 14, damping), 14, damping), 0.055);
    }
}

// More pulses: broader. Half-widths at 5 % of vibration, undamped, by Singhose and by Klipper.
TEST(Shaper, ToleratesAWrongFrequency) {
    const auto worst = [](ShaperKind kind, double off) {
        const auto pulses = shaper(kind, 40, 0);
        return std::max(residual_vibration(pulses, 40 * (1 - off), 0),
                        residual_vibration(pulses, 40 * (1 + off), 0));
    };
    EXPECT_NEAR(worst(ShaperKind::zv, 0.03), 0.05, 0.01);
    EXPECT_LT(worst(ShaperKind::zvd, 0.13), 0.05);
    EXPECT_LT(worst(ShaperKind::ei, 0.19), 0.055);
    EXPECT_LT(worst(ShaperKind::two_hump_ei, 0.33), 0.06);
    EXPECT_LT(worst(ShaperKind::three_hump_ei, 0.43), 0.06);
    EXPECT_GT(worst(ShaperKind::ei, 0.4), worst(ShaperKind::two_hump_ei, 0.4));
}

// The example of Klipper's documentation.
TEST(Shaper, SmoothsAsKlipperSays) {
    EXPECT_NEAR(smoothing(shaper(ShaperKind::mzv, 34.6, 0.1), 5000, 5), 0.170, 0.002);
}

TEST(Shaper, GainIsOneAtRestAndNoneAtTheModeOfZv) {
    EXPECT_NEAR(std::abs(gain(shaper(ShaperKind::mzv, 20, 0.05), 0)), 1, 1e-12);
    EXPECT_NEAR(std::abs(gain(shaper(ShaperKind::zv, 20, 0), 2 * std::numbers::pi * 20)), 0, 1e-12);
}

}  // namespace
}  // namespace bead
