#include "energy/tariff.h"

#include <gtest/gtest.h>

namespace bead {
namespace {

const Tariff night_and_day{{0, 6 * 3600, 0.12}, {6 * 3600, day, 0.30}};

TEST(Billing, ChargesEachHourItsOwnPrice) {
    Billing billing(night_and_day, 22 * 3600);
    EXPECT_NEAR(billing.next_change(0), 2 * 3600, 1e-5);
    EXPECT_NEAR(billing.next_change(2 * 3600), 8 * 3600, 1e-5);
    billing.add({0, 2 * 3600, true, {.bed = joules_per_kwh}});
    billing.add({2 * 3600, 6 * 3600, false, {.bed = joules_per_kwh, .fans = joules_per_kwh}});
    EXPECT_NEAR(billing.bill().heat_up, 0.30, 1e-12);
    EXPECT_NEAR(billing.bill().print, 2 * 0.12, 1e-12);
    EXPECT_EQ(billing.bill().energy[0], 2 * joules_per_kwh);
}

TEST(Billing, GoesOnAfterADay) {
    Billing billing(night_and_day, 0);
    billing.add({day + 3600, 60, false, {.bed = joules_per_kwh}});
    EXPECT_NEAR(billing.bill().print, 0.12, 1e-12);
}

}  // namespace
}  // namespace bead
