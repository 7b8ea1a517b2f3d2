#include "energy/power_trace.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/error.h"

namespace bead {
namespace {

// Standby, a print that heats with all it has and then pulses, standby.
PowerTrace plug(double before, double print, double after, double interval = 2) {
    std::vector<PowerSample> samples;
    for (double t = 0; t <= before + print + after; t += interval) {
        const double since = t - before;
        const bool on = since >= 0 && since <= print;
        const double pulses = std::fmod(t, 40) < 20 ? 130 : 40;
        samples.push_back({t, on ? (since < 200 ? 230 : pulses) : 8});
    }
    return power_trace(std::move(samples));
}

RC_GTEST_PROP(PowerTrace, EnergyAddsUpOverStretches, ()) {
    const PowerTrace trace = plug(300, 3000, 300);
    const double a = *rc::gen::inRange(0, 1800), b = *rc::gen::inRange(1800, 3600);
    const double middle = a + (b - a) * *rc::gen::inRange(0, 100) / 100.0;
    const Metered whole = metered(trace, a, b);
    const double sum = metered(trace, a, middle).energy + metered(trace, middle, b).energy;
    RC_ASSERT(std::abs(whole.energy - sum) < 1e-6);
    RC_ASSERT(std::abs(whole.recorded - (b - a)) < 1e-9);
    RC_ASSERT(whole.gaps.empty());
}

TEST(PowerTrace, OfARampIsItsMean) {
    const PowerTrace trace = power_trace({{0, 0}, {10, 100}, {20, 0}});
    EXPECT_NEAR(metered(trace, 0, 20).energy, 1000, 1e-9);
    EXPECT_NEAR(metered(trace, 5, 15).energy, 750, 1e-9);
}

TEST(PowerTrace, LeavesGapsUnknown) {
    PowerTrace trace = plug(300, 3000, 300);
    std::erase_if(trace.samples,
                  [](const PowerSample& s) { return s.time > 1000 && s.time < 1600; });
    const Metered drawn = metered(trace, 300, 3300);
    ASSERT_EQ(drawn.gaps.size(), 1U);
    EXPECT_DOUBLE_EQ(drawn.gaps[0].from, 1000);
    EXPECT_DOUBLE_EQ(drawn.gaps[0].to, 1600);
    EXPECT_DOUBLE_EQ(drawn.recorded, 2400);
    const Metered whole = metered(plug(300, 3000, 300), 300, 3300);
    EXPECT_NEAR(whole.energy - drawn.energy, metered(plug(300, 3000, 300), 1000, 1600).energy,
                1e-6);
}

TEST(PowerTrace, BeyondTheLogIsAGap) {
    const PowerTrace trace = power_trace({{0, 50}, {1, 50}, {2, 50}});
    const Metered drawn = metered(trace, -3, 4);
    EXPECT_EQ(drawn.gaps.size(), 2U);
    EXPECT_DOUBLE_EQ(drawn.recorded, 2);
    EXPECT_DOUBLE_EQ(drawn.energy, 100);
}

// Wherever in the log it stands, however long: within an interval.
RC_GTEST_PROP(FindPrint, FindsItsBeginAndEnd, ()) {
    const double before = *rc::gen::inRange(100, 4000), print = *rc::gen::inRange(600, 20000),
                 after = *rc::gen::inRange(100, 4000);
    const FoundPrint found = find_print(plug(before, print, after), print);
    RC_ASSERT(std::abs(found.from - before) <= 2);
    RC_ASSERT(std::abs(found.to - before - print) <= 2);
    RC_ASSERT(std::abs(found.scale - 1) < 0.01);
    RC_ASSERT(found.others == 0U);
    RC_ASSERT(!found.cut_begin && !found.cut_end);
}

TEST(FindPrint, TellsAClockThatDrifts) {
    PowerTrace trace = plug(300, 10000, 300);
    for (PowerSample& sample : trace.samples) sample.time *= 1.03;
    EXPECT_NEAR(find_print(trace, 10000).scale, 1.03, 0.001);
}

TEST(FindPrint, TakesThePrintOfTheRightLength) {
    PowerTrace trace = plug(300, 2000, 1000);
    const PowerTrace second = plug(300, 5000, 300);
    for (const PowerSample& sample : second.samples)
        trace.samples.push_back({sample.time + 3400, sample.watts});
    const FoundPrint found = find_print(trace, 4900);
    EXPECT_NEAR(found.from, 3700, 2);
    EXPECT_EQ(found.others, 1U);
    EXPECT_NEAR(find_print(trace, 2100).from, 300, 2);
}

TEST(FindPrint, SaysWhenTheLogIsCut) {
    EXPECT_TRUE(find_print(plug(0, 2000, 300), 2000).cut_begin);
    EXPECT_TRUE(find_print(plug(300, 2000, 0), 2000).cut_end);
}

TEST(FindPrint, RefusesALogWithoutARise) {
    std::vector<PowerSample> flat;
    for (int i = 0; i < 100; ++i) flat.push_back({double(i), 80 + 0.1 * (i % 5)});
    EXPECT_THROW(find_print(power_trace(flat), 60), Error);
}

}  // namespace
}  // namespace bead
