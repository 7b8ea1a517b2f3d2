#include "energy/motors.h"

#include <algorithm>
#include <cmath>

namespace bead {

namespace {

constexpr double newton_mm = 1e-3;      // J
constexpr double kg_mm2_per_s2 = 1e-6;  // J

// Path lengths of the three phases, mm.
struct Phases {
    double accelerating = 0, cruising = 0, braking = 0;
};

Phases phases_of(const Block& block) {
    return {(block.v_entry + block.v_peak) / 2 * block.t_accel, block.v_peak * block.t_cruise,
            (block.v_peak + block.v_exit) / 2 * block.t_decel};
}

// Cost per mm of axis travel in the three phases, J/mm.
struct AxisCost {
    double accelerating = 0, cruising = 0, braking = 0;
};

AxisCost cost_of(const Motor& motor, double acceleration) {
    const double friction = motor.friction * newton_mm;
    const double inertia = motor.moving_mass * acceleration * kg_mm2_per_s2;
    const auto cost = [&](double force) {
        return motor.per_speed + std::max(0.0, force) / motor.efficiency;
    };
    return {cost(friction + inertia), cost(friction), cost(friction - inertia)};
}

double dearest(const Block& block, const AxisCost& cost) {
    if (block.t_accel > 0) return cost.accelerating;
    return block.t_cruise > 0 ? cost.cruising : cost.braking;
}

}  // namespace

MotorDraw motor_draw(const std::array<Motor, 4>& motors, const Block& block) {
    MotorDraw draw;
    if (block.length <= 0) return draw;
    const Phases way = phases_of(block);
    for (std::size_t axis = 0; axis < motors.size(); ++axis) {
        const double share = std::abs(block.delta[axis]) / block.length;
        const AxisCost cost = cost_of(motors[axis], block.acceleration * share);
        const double joules = share * (cost.accelerating * way.accelerating +
                                       cost.cruising * way.cruising + cost.braking * way.braking);
        draw.all += joules;
        if (axis == axis_x || axis == axis_y) draw.xy += joules;
        draw.peak += share * block.v_peak * dearest(block, cost);
    }
    return draw;
}

}  // namespace bead
