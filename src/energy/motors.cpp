#include "energy/motors.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"
#include "energy/units.h"
#include "motion/linear_drive.h"

namespace bead {
namespace {

// Per mm of the head's way, J/mm; or with the phases' ways put in, J.
struct Phased {
    double accelerating = 0, cruising = 0, braking = 0;
    Phased& operator+=(const Phased& other) {
        accelerating += other.accelerating;
        cruising += other.cruising;
        braking += other.braking;
        return *this;
    }
};

double dot(const Phased& a, const Phased& b) {
    return a.accelerating * b.accelerating + a.cruising * b.cruising + a.braking * b.braking;
}

// mm of the head's way.
Phased ways_of(const Block& block) {
    return {(block.v_entry + block.v_peak) / 2 * block.t_accel, block.v_peak * block.t_cruise,
            (block.v_peak + block.v_exit) / 2 * block.t_decel};
}

// Against friction and inertia. `steady`, `extra`: what a motor's pull gives to motion while
// cruising, and more while speeding up, J per mm of the head's way.
Phased work_of(const Motor& motor, double steady, double extra) {
    const double per_output = 1 / motor.efficiency;
    const auto cost = [&](double work) { return std::max(0.0, work) * per_output; };
    return {cost(steady + extra), cost(steady), cost(steady - extra)};
}

double dearest(const Block& block, const Phased& cost) {
    return std::max({block.t_accel > 0 ? cost.accelerating : 0,
                     block.t_cruise > 0 ? cost.cruising : 0, block.t_decel > 0 ? cost.braking : 0});
}

template <Kinematics kind>
MotorDraw drawn(const std::array<Motor, 4>& motors, const Block& block) {
    PerAxis<double> share{}, drag{}, inertia{};
    for (std::size_t axis = 0; axis < motors.size(); ++axis) {
        const double u = block.delta[axis] / block.length;
        share[axis] = u;
        if (u != 0) drag[axis] = std::copysign(motors[axis].friction * newton_mm, u);
        inertia[axis] = motors[axis].moving_mass * block.acceleration * u * kg_mm2_per_s2;
    }
    const PerAxis<double> rate = motors_of<kind>(share);
    const PerAxis<double> drag_pull = pulls_of<kind>(drag), inertia_pull = pulls_of<kind>(inertia);
    const Phased way = ways_of(block);
    MotorDraw draw;
    Phased all;
    for (std::size_t slot = 0; slot < motors.size(); ++slot) {
        const double loss = motors[slot].per_speed * std::abs(rate[slot]);
        const Phased work =
            work_of(motors[slot], drag_pull[slot] * rate[slot], inertia_pull[slot] * rate[slot]);
        draw.turns[slot] = rate[slot] != 0;
        draw.speed[slot] = loss * (way.accelerating + way.cruising + way.braking);
        draw.work[slot] = dot(way, work);
        all += work;
        all += {loss, loss, loss};
    }
    draw.peak = block.v_peak * dearest(block, all);
    return draw;
}

}  // namespace

MotorDraw motor_draw(const std::array<Motor, 4>& motors, const Block& block,
                     Kinematics kinematics) {
    BEAD_EXPECTS(kinematics != Kinematics::delta);
    if (block.length <= 0) return {};
    if (kinematics == Kinematics::corexy) return drawn<Kinematics::corexy>(motors, block);
    if (kinematics == Kinematics::corexz) return drawn<Kinematics::corexz>(motors, block);
    return drawn<Kinematics::cartesian>(motors, block);
}

}  // namespace bead
