#include "energy/motors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/blocks.h"
#include "support/power_twin.h"

namespace bead {
namespace {

using namespace test;

Motor any_motor() {
    return {.standing = number_between(0, 3),
            .per_speed = number_between(0, 0.1),
            .friction = number_between(0, 20),
            .moving_mass = number_between(0, 20),
            .efficiency = number_between(0.2, 1)};
}

TEST(MotorDraw, OfAFrictionlessStartAndStopIsTheMovingEnergyOnce) {
    std::array<Motor, 4> motors{};
    motors[axis_x].moving_mass = 0.5;
    const Block block = trapezoid({100, 0, 0, 0}, 0, 0, 80, 1000);
    EXPECT_NEAR(motor_draw(motors, block).all, 0.5 * 0.5 * 0.08 * 0.08, 1e-12);
    EXPECT_NEAR(motor_draw(motors, block).peak, 0.5 * 1.0 * 0.08, 1e-12);
}

TEST(MotorDraw, WithFrictionThatBrakesByItselfIsFrictionTimesDistance) {
    std::array<Motor, 4> motors{};
    motors[axis_y] = {.friction = 5, .moving_mass = 0.5};
    const Block block = trapezoid({0, 100, 0, 0}, 0, 0, 80, 1000);
    EXPECT_NEAR(motor_draw(motors, block).xy, 5 * 0.1, 1e-12);
}

RC_GTEST_PROP(MotorDraw, AgreesWithSmallSteps, ()) {
    const std::array<Motor, 4> motors{any_motor(), any_motor(), any_motor(), any_motor()};
    const Block block = any_block();
    const int steps = 5000;
    const TwinDraw twin = motors_by_steps(motors, block, steps);
    double standing = 0;
    for (const Motor& motor : motors) standing += motor.standing;
    const MotorDraw draw = motor_draw(motors, block);
    RC_ASSERT(std::abs(draw.all + standing * duration(block) - twin.energy) <=
              1e-3 * twin.energy + 1e-9);
    RC_ASSERT(std::abs(draw.peak + standing - twin.peak) <= 1e-3 * twin.peak + 1e-9);
}

RC_GTEST_PROP(MotorDraw, ExchangesWithTheAxes, ()) {
    const Motor motor = any_motor();
    const std::array<Motor, 4> motors{motor, motor, any_motor(), any_motor()};
    const Block block = any_block();
    Block turned = block;
    std::swap(turned.delta[axis_x], turned.delta[axis_y]);
    const MotorDraw a = motor_draw(motors, block), b = motor_draw(motors, turned);
    RC_ASSERT(std::abs(a.xy - b.xy) <= 1e-12 * a.xy && std::abs(a.all - b.all) <= 1e-12 * a.all);
}

}  // namespace
}  // namespace bead
