#include "numeric/bootstrap.h"

#include <gtest/gtest.h>

#include <random>

namespace bead {
namespace {

struct Sample {
    Rows rows;
    std::vector<double> values;
};

Sample noisy_line(unsigned seed, double noise) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Sample s;
    for (int i = 0; i < 40; ++i) {
        s.rows.push_back({1, i / 10.0});
        s.values.push_back(2 + 3 * i / 10.0 + noise * normal(random));
    }
    return s;
}

TEST(Bootstrap, HoldsTheTruthInAboutNineteenOfTwenty) {
    int held = 0;
    const int samples = 200;
    for (unsigned seed = 0; seed < samples; ++seed) {
        const Sample s = noisy_line(seed, 0.5);
        const auto slope = bootstrap(s.rows, s.values, {}, {300, seed}).coefficients[1];
        if (slope.low <= 3 && 3 <= slope.high) ++held;
    }
    EXPECT_NEAR(double(held) / samples, 0.93, 0.05);
}

TEST(Bootstrap, OfExactRowsIsAPoint) {
    const Sample s = noisy_line(1, 0);
    for (const Percentiles& p : bootstrap(s.rows, s.values, {}).coefficients)
        EXPECT_NEAR(p.low, p.high, 1e-9);
}

TEST(Bootstrap, IsTheSameForTheSameSeedOnly) {
    const Sample s = noisy_line(1, 1);
    const auto low = [&](std::uint64_t seed) {
        return bootstrap(s.rows, s.values, {}, {200, seed}).coefficients[0].low;
    };
    EXPECT_EQ(low(5), low(5));
    EXPECT_NE(low(5), low(6));
}

TEST(Bootstrap, CountsOnlyDrawsThatDecideAllCoefficients) {
    // The second column is told by one row alone, which about 1/e of the draws lack.
    const Rows rows{{1, 0}, {1, 0}, {1, 0}, {1, 0}, {1, 0}, {1, 0}, {1, 0}, {1, 1}};
    const Bootstrap some = bootstrap(rows, {1, 1, 1, 1, 1, 1, 1, 3}, {}, {1000, 1});
    EXPECT_NEAR(some.fitted / 1000.0, 1 - std::pow(7.0 / 8, 8), 0.05);
    const Bootstrap none = bootstrap({{1, 1}, {2, 2}}, {1, 2}, {});
    EXPECT_EQ(none.fitted, 0);
    EXPECT_TRUE(none.coefficients.empty());
}

}  // namespace
}  // namespace bead
