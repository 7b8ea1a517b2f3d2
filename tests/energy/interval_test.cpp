#include "energy/interval.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/blocks.h"

namespace bead {
namespace {

const Energy some{.bed = 100, .hotend = 50, .motors = 20, .fans = 5, .electronics = 25};

TEST(Interval, IsAPointIfAllIsKnown) {
    const Interval sure = interval_95(some, {});
    EXPECT_EQ(sure.low, 200);
    EXPECT_EQ(sure.high, 200);
}

TEST(Interval, ReachesTwoStandardUncertaintiesOfOneConsumer) {
    PowerModel power;
    power.uncertainty.bed = 0.1;
    EXPECT_NEAR(interval_95(some, power).high, 200 + 1.96 * 10, 1e-2);
}

TEST(Interval, AddsIndependentOnesAsSquares) {
    PowerModel power;
    power.uncertainty = {.bed = 0.03, .hotend = 0.08};  // 3 J and 4 J
    EXPECT_NEAR(interval_95(some, power).low, 200 - 1.96 * 5, 1e-2);
}

TEST(Interval, LeavesABedOnTheMainsOutOfTheSupply) {
    PowerModel power;
    power.uncertainty.supply = 0.1;
    const double all = interval_95(some, power).high - 200;
    power.bed.mains = true;
    EXPECT_NEAR((interval_95(some, power).high - 200) / all, 0.5, 1e-12);
}

// The rectangle of appendix D, rectilinear at 0 degrees: one print of 8 kJ like those of the fit.
const Features rectangle{2602000, 8151000, 75490, 1662, 3348};

TEST(PublishedInterval, ContainsTheValue) {
    const Interval published = published_interval_95(rectangle);
    const double energy = published_energy(rectangle);
    EXPECT_TRUE(published.low < energy && energy < published.high);
    const Interval standing = standing_interval_95(rectangle);
    EXPECT_TRUE(standing.low < standing_form(rectangle) &&
                standing_form(rectangle) < standing.high);
}

TEST(PublishedInterval, IsAtLeastTheResidualsOfThePrints) {
    const Interval nothing = published_interval_95({.A = 1});
    EXPECT_NEAR(nothing.high, 100.1529 * 2.446912, 0.01);
    const Interval some_print = published_interval_95(rectangle);
    EXPECT_GT(some_print.high - some_print.low, 2 * nothing.high);
}

RC_GTEST_PROP(Interval, ContainsTheValue, ()) {
    const auto any = [] { return test::number_between(0, 1); };
    const Energy energy{any(), any(), any(), any(), any()};
    PowerModel power;
    power.uncertainty = {any(), any(), any(), any(), any(), any()};
    const Interval interval = interval_95(energy, power);
    RC_ASSERT(interval.low <= total(energy) && total(energy) <= interval.high);
}

TEST(Interval, IsNeverBelowNothing) {
    PowerModel power;
    power.uncertainty.bed = 5;
    EXPECT_EQ(interval_95(some, power).low, 0);
}

}  // namespace
}  // namespace bead
