#include "energy/delta_motors.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/delta_twin.h"

namespace bead {
namespace {

using namespace test;

constexpr double g = 9.80665;

Motor any_motor() {
    return {.per_speed = number_between(0, 0.1),
            .friction = number_between(0, 5),
            .moving_mass = number_between(0, 1),
            .efficiency = number_between(0.2, 1)};
}

// Three alike, no losses; the carriages weigh 0.2 kg each.
std::array<Motor, 4> ideal_motors() {
    std::array<Motor, 4> motors{};
    for (std::size_t i = 0; i < 3; ++i) motors[i].moving_mass = 0.2;
    return motors;
}

TEST(DeltaDraw, OfALiftIsTheWeightTimesTheHeight) {
    const Block up = trapezoid({0, 0, 50, 0}, 0, 0, 80, 3000);
    const double weight = (a_delta.head_mass + 3 * 0.2) * g;
    const MotorDraw draw = delta_draw(ideal_motors(), a_delta, {}, up);
    EXPECT_NEAR(total(draw), weight * 0.05, 1e-6);
    EXPECT_NEAR(draw.peak, weight * (1 + 3 / g) * 0.08, 1e-6);
    EXPECT_EQ(xy_part(draw, Kinematics::delta), total(draw));
}

TEST(DeltaDraw, OfADescentIsNothing) {
    const Block down = trapezoid({0, 0, -50, 0}, 0, 0, 80, 3000);
    EXPECT_EQ(total(delta_draw(ideal_motors(), a_delta, {}, down)), 0);
}

TEST(DeltaDraw, OfTheExtruderAloneIsThatOfAnyMachine) {
    std::array<Motor, 4> motors = ideal_motors();
    motors[axis_e].friction = 30;
    const Block push = trapezoid({0, 0, 0, 2}, 0, 0, 30, 1000);
    EXPECT_EQ(total(delta_draw(motors, a_delta, {}, push)), total(motor_draw(motors, push)));
    EXPECT_EQ(xy_part(delta_draw(motors, a_delta, {}, push), Kinematics::delta), 0);
}

RC_GTEST_PROP(DeltaDraw, AgreesWithSmallSteps, ()) {
    const std::array<Motor, 4> motors{any_motor(), any_motor(), any_motor(), {}};
    const PlacedBlock placed = any_placed_block();
    const double twin = towers_by_steps(motors, a_delta, placed, 3000);
    const MotorDraw draw = delta_draw(motors, a_delta, placed.from, placed.block);
    RC_ASSERT(std::abs(xy_part(draw, Kinematics::delta) - twin) <= 4e-3 * twin + 1e-6);
    RC_ASSERT(xy_part(draw, Kinematics::delta) <= draw.peak * duration(placed.block) * (1 + 1e-9));
}

RC_GTEST_PROP(DeltaDraw, WithEqualMotorsIsTheSameAfterAThirdOfATurn, ()) {
    const Motor motor = any_motor();
    const std::array<Motor, 4> motors{motor, motor, motor, any_motor()};
    const PlacedBlock placed = any_placed_block();
    Block turned = placed.block;
    const Vec2 third = unit(2 * pi / 3);
    const Vec2 move = rotated({turned.delta[axis_x], turned.delta[axis_y]}, third);
    turned.delta[axis_x] = move.x;
    turned.delta[axis_y] = move.y;
    const double before = total(delta_draw(motors, a_delta, placed.from, placed.block));
    const double after = total(delta_draw(motors, a_delta, rotated(placed.from, third), turned));
    RC_ASSERT(std::abs(before - after) <= 1e-6 * (1 + before));
}

}  // namespace
}  // namespace bead
