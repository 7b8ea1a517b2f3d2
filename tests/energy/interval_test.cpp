#include "energy/interval.h"

#include <gtest/gtest.h>

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

TEST(Interval, IsNeverBelowNothing) {
    PowerModel power;
    power.uncertainty.bed = 5;
    EXPECT_EQ(interval_95(some, power).low, 0);
}

}  // namespace
}  // namespace bead
