#include "numeric/welch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "numeric/decimate.h"

namespace bead {
namespace {

constexpr double pi = std::numbers::pi;

double total(const Welch::Density& d) {
    return std::accumulate(d.power.begin(), d.power.end(), 0.0) / double(d.length);
}

TEST(Welch, KeepsThePowerOfNoiseAndAddsComponents) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> x(0, 2), y(0, 1);
    Welch welch;
    for (int i = 0; i < 200'000; ++i) welch.add({x(random), y(random)});
    EXPECT_NEAR(total(welch.density()), 4 + 1, 0.1);
}

TEST(Welch, FindsASineWhereItIs) {
    Welch welch;
    for (int i = 0; i < 20'000; ++i) welch.add(3 * std::sin(2 * pi * 36.0 / 512 * i));
    const Welch::Density d = welch.density();
    const auto peak = std::max_element(d.power.begin(), d.power.end());
    EXPECT_EQ(peak - d.power.begin(), 36);
    EXPECT_NEAR(total(d), 4.5, 0.05);
}

TEST(Welch, TakesAShortSignalAsOneSegment) {
    Welch welch;
    EXPECT_EQ(welch.density().segments, 0U);
    for (int i = 0; i < 101; ++i) welch.add(std::cos(2 * pi * i / 10));
    EXPECT_EQ(welch.density().segments, 1U);
    EXPECT_EQ(welch.density().length, 101U);
}

TEST(Decimator, PassesWhatIsSlowAndStopsWhatIsFast) {
    for (const double cycles : {0.01, 0.03, 0.08, 0.2, 0.45}) {  // per sample; limit 0.05
        Decimator decimator(10);
        double most = 0;
        for (int i = 0; i < 5000; ++i)
            if (decimator.add(std::polar(1.0, 2 * pi * cycles * i)) && i > 1000)
                most = std::max(most, std::abs(decimator.value()));
        EXPECT_NEAR(most, cycles < 0.04 ? 1 : 0, 0.01) << cycles;
    }
}

}  // namespace
}  // namespace bead
