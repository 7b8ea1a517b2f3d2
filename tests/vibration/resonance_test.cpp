#include "vibration/resonance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace bead {
namespace {

struct Measured {
    std::vector<double> frequency, power;
};

Measured shaken(double f0, double damping, double noise) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal(0, noise);
    Measured m;
    for (double f = 5; f <= 133; f += 0.4) {
        const double r = f / f0, swing = std::pow(2 * damping * r, 2);
        m.frequency.push_back(f);
        m.power.push_back(1e4 * (1 + swing) / (std::pow(1 - r * r, 2) + swing) *
                          std::exp(normal(random)));
    }
    return m;
}

TEST(Resonance, IsFoundAgain) {
    for (const double f0 : {9.0, 22.0, 47.3, 90.0})
        for (const double damping : {0.03, 0.06, 0.12}) {
            const Measured clean = shaken(f0, damping, 0);
            const auto mode = fitted_mode(clean.frequency, clean.power);
            ASSERT_TRUE(mode);
            EXPECT_NEAR(mode->frequency, f0, 1e-3 * f0);
            EXPECT_NEAR(mode->damping, damping, 0.02 * damping);
        }
}

TEST(Resonance, StandsNoise) {
    const Measured noisy = shaken(47.3, 0.06, 0.1);
    const auto mode = fitted_mode(noisy.frequency, noisy.power);
    ASSERT_TRUE(mode);
    EXPECT_NEAR(mode->frequency, 47.3, 0.5);
    EXPECT_NEAR(mode->damping, 0.06, 0.01);
}

TEST(Resonance, IsNothingWhereThereIsNoPeak) {
    std::vector<double> frequency, rising, flat;
    for (int i = 0; i < 100; ++i) {
        frequency.push_back(i + 5);
        rising.push_back(i);
        flat.push_back(0);
    }
    EXPECT_FALSE(fitted_mode(frequency, rising));
    EXPECT_FALSE(fitted_mode(frequency, flat));
    EXPECT_FALSE(fitted_mode({}, {}));
}

}  // namespace
}  // namespace bead
