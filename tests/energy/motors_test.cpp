#include "energy/motors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/vec.h"
#include "support/blocks.h"
#include "support/power_twin.h"

namespace bead {
namespace {

using namespace test;

Motor some_motor() {
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
    EXPECT_NEAR(total(motor_draw(motors, block)), 0.5 * 0.5 * 0.08 * 0.08, 1e-12);
    EXPECT_NEAR(motor_draw(motors, block).peak, 0.5 * 1.0 * 0.08, 1e-12);
}

TEST(MotorDraw, WithFrictionThatBrakesByItselfIsFrictionTimesDistance) {
    std::array<Motor, 4> motors{};
    motors[axis_y] = {.friction = 5, .moving_mass = 0.5};
    const Block block = trapezoid({0, 100, 0, 0}, 0, 0, 80, 1000);
    EXPECT_NEAR(xy_part(motor_draw(motors, block)), 5 * 0.1, 1e-12);
}

RC_GTEST_PROP(MotorDraw, AgreesWithSmallSteps, ()) {
    const std::array<Motor, 4> motors{some_motor(), some_motor(), some_motor(), some_motor()};
    const Block block = any_block();
    const int steps = 5000;
    const TwinDraw twin = motors_by_steps(motors, block, steps);
    double standing = 0;
    for (const Motor& motor : motors) standing += motor.standing;
    const MotorDraw draw = motor_draw(motors, block);
    RC_ASSERT(std::abs(total(draw) + standing * duration(block) - twin.energy) <=
              1e-3 * twin.energy + 1e-9);
    RC_ASSERT(std::abs(draw.peak + standing - twin.peak) <= 1e-3 * twin.peak + 1e-9);
}

RC_GTEST_PROP(MotorDraw, ExchangesWithTheAxes, ()) {
    const Motor motor = some_motor();
    const std::array<Motor, 4> motors{motor, motor, some_motor(), some_motor()};
    const Block block = any_block();
    Block turned = block;
    std::swap(turned.delta[axis_x], turned.delta[axis_y]);
    const MotorDraw a = motor_draw(motors, block), b = motor_draw(motors, turned);
    RC_ASSERT(std::abs(xy_part(a) - xy_part(b)) <= 1e-12 * xy_part(a) &&
              std::abs(total(a) - total(b)) <= 1e-12 * total(a));
}

// A CoreXY by small steps: forces along the axes, halves of their sum and difference on the belts.
double core_by_steps(const std::array<Motor, 4>& motors, const Block& b, int steps) {
    const auto phase = [&](double v0, double v1, double seconds) {
        double joules = 0;
        for (int k = 0; seconds > 0 && k < steps; ++k) {
            const double speed = v0 + (v1 - v0) * (k + 0.5) / steps, a = (v1 - v0) / seconds;
            std::array<double, 2> v{}, f{};  // m/s, N
            for (std::size_t i = 0; i < 2; ++i) {
                const double u = b.delta[i] / b.length;
                v[i] = u * speed / 1000;
                f[i] = motors[i].moving_mass * u * a / 1000 + (u > 0   ? motors[i].friction
                                                               : u < 0 ? -motors[i].friction
                                                                       : 0);
            }
            const std::array<double, 2> w{v[0] + v[1], v[0] - v[1]},
                pull{(f[0] + f[1]) / 2, (f[0] - f[1]) / 2};
            for (std::size_t m = 0; m < 2; ++m)
                joules += seconds / steps *
                          (motors[m].per_speed * std::abs(w[m]) * 1000 +
                           std::max(0.0, pull[m] * w[m]) / motors[m].efficiency);
        }
        return joules;
    };
    return phase(b.v_entry, b.v_peak, b.t_accel) + phase(b.v_peak, b.v_peak, b.t_cruise) +
           phase(b.v_peak, b.v_exit, b.t_decel);
}

RC_GTEST_PROP(CoreDraw, AgreesWithSmallSteps, ()) {
    const std::array<Motor, 4> motors{some_motor(), some_motor(), some_motor(), some_motor()};
    const Block block = any_block();
    const double twin = core_by_steps(motors, block, 3000);
    RC_ASSERT(std::abs(xy_part(motor_draw(motors, block, Kinematics::corexy), Kinematics::corexy) -
                       twin) <= 1e-3 * twin + 1e-9);
}

RC_GTEST_PROP(CoreDraw, TurnedByAnEighthIsCartesianWithFasterMotors, ()) {
    Motor motor = some_motor();
    motor.friction = 0;  // rails stay where they are
    const std::array<Motor, 4> core{motor, motor, {}, {}};
    std::array<Motor, 4> cartesian = core;
    for (std::size_t i = 0; i < 2; ++i) cartesian[i].per_speed *= std::sqrt(2);
    const Block block = any_block();
    Block turned = block;
    const Vec2 d = rotated({block.delta[axis_x], block.delta[axis_y]}, unit(pi / 4));
    turned.delta[axis_x] = d.x;
    turned.delta[axis_y] = d.y;
    const double a = total(motor_draw(cartesian, block));
    const double b = total(motor_draw(core, turned, Kinematics::corexy));
    RC_ASSERT(std::abs(a - b) <= 1e-9 * (a + 1e-6));
}

RC_GTEST_PROP(CoreDraw, AlongXTakesTheSameWorkAsOneMotorAndLosesOfTwo, ()) {
    Motor motor = some_motor();
    const std::array<Motor, 4> motors{motor, motor, {}, {}};
    Block block = any_block();
    block.delta[axis_y] = 0;
    const double loss = motor.per_speed * std::abs(block.delta[axis_x]);
    const double one = xy_part(motor_draw(motors, block));
    const double two = xy_part(motor_draw(motors, block, Kinematics::corexy), Kinematics::corexy);
    RC_ASSERT(std::abs(two - one - loss) <= 1e-9 * (1 + two));
}

TEST(CoreDraw, OfADiagonalIsThatOfOneMotorAlone) {
    std::array<Motor, 4> motors{};
    for (std::size_t i = 0; i < 2; ++i)
        motors[i] = {.per_speed = 0.05, .friction = 2, .moving_mass = 1};
    const Block diagonal = trapezoid({50, 50, 0, 0}, 20, 20, 80, 1000);
    const double whole =
        xy_part(motor_draw(motors, diagonal, Kinematics::corexy), Kinematics::corexy);
    motors[1].per_speed = 7;
    motors[1].efficiency = 0.1;
    EXPECT_DOUBLE_EQ(xy_part(motor_draw(motors, diagonal, Kinematics::corexy), Kinematics::corexy),
                     whole);
}

RC_GTEST_PROP(CoreDraw, InXZIsThatInXYWithYAndZExchanged, ()) {
    const std::array<Motor, 4> motors{some_motor(), some_motor(), some_motor(), some_motor()};
    const Block block = any_block();
    std::array<Motor, 4> exchanged = motors;
    Block lying = block;
    std::swap(exchanged[axis_y], exchanged[axis_z]);
    std::swap(lying.delta[axis_y], lying.delta[axis_z]);
    const MotorDraw a = motor_draw(motors, block, Kinematics::corexz);
    const MotorDraw b = motor_draw(exchanged, lying, Kinematics::corexy);
    RC_ASSERT(std::abs(total(a) - total(b)) <= 1e-12 * total(a) &&
              std::abs(a.peak - b.peak) <= 1e-9 * a.peak);
}

}  // namespace
}  // namespace bead
