#include "motion/trapezoid.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace bead {
namespace {

double distance(const Trapezoid& t) {
    return t.t_accel * (t.v_entry + t.v_peak) / 2 + t.t_cruise * t.v_peak +
           t.t_decel * (t.v_peak + t.v_exit) / 2;
}

TEST(Trapezoid, HundredMillimetresFromRestToRest) {
    const Trapezoid t = trapezoid(100, 80, 0, 0, 1000);
    EXPECT_DOUBLE_EQ(t.v_peak, 80);
    EXPECT_DOUBLE_EQ(t.t_accel, 0.08);
    EXPECT_DOUBLE_EQ(t.t_cruise, 1.17);
    EXPECT_DOUBLE_EQ(t.t_decel, 0.08);
}

TEST(Trapezoid, TwoMillimetresNeverReachTheirSpeed) {
    const Trapezoid t = trapezoid(2, 80, 0, 0, 1000);
    EXPECT_NEAR(t.v_peak, std::sqrt(2000.0), 1e-12);
    EXPECT_NEAR(t.t_accel + t.t_cruise + t.t_decel, 0.0894427191, 1e-9);
    EXPECT_EQ(t.t_cruise, 0);
}

RC_GTEST_PROP(Trapezoid, CoversItsLengthWithinItsLimits, ()) {
    const auto number = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
    const double length = number(1, 400'000), nominal = number(1, 300'000);
    const double acceleration = number(1'000, 9'000'000);
    const double entry = number(0, 400'000), exit = number(0, 400'000);
    const Trapezoid t = trapezoid(length, nominal, entry, exit, acceleration);
    RC_ASSERT(std::abs(distance(t) - length) < 1e-9 * length + 1e-12);
    RC_ASSERT(t.v_entry <= nominal && t.v_peak <= nominal && t.v_exit <= nominal);
    RC_ASSERT(t.v_peak >= std::max(t.v_entry, t.v_exit));
    RC_ASSERT(std::abs(t.v_exit * t.v_exit - t.v_entry * t.v_entry) <=
              2 * acceleration * length * (1 + 1e-12));
    RC_ASSERT(t.t_accel >= 0 && t.t_cruise >= 0 && t.t_decel >= 0);
}

RC_GTEST_PROP(Trapezoid, TakesAsLongBackwards, ()) {
    const double length = *rc::gen::inRange(1, 100'000) / 1000.0;
    const double entry = *rc::gen::inRange(0, 100) / 1.0;
    const Trapezoid there = trapezoid(length, 100, entry, 0, 3000);
    const Trapezoid back = trapezoid(length, 100, there.v_exit, there.v_entry, 3000);
    RC_ASSERT(std::abs(there.t_accel - back.t_decel) < 1e-12);
    RC_ASSERT(std::abs(there.t_cruise - back.t_cruise) < 1e-9);
}

}  // namespace
}  // namespace bead
