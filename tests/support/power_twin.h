// What the closed forms of energy/ must agree with: the same physics in small steps of time.
#pragma once
#include <algorithm>
#include <cmath>

#include "machine/power.h"
#include "motion/block.h"

namespace bead::test {

// W of one motor, standing included, in SI units throughout.
inline double motor_power(const Motor& motor, double speed_mm, double acceleration_mm) {
    const double v = speed_mm / 1000, a = acceleration_mm / 1000;
    const double push = (motor.moving_mass * a + motor.friction) * v;
    return motor.standing + motor.per_speed * speed_mm + std::max(0.0, push) / motor.efficiency;
}

struct TwinDraw {
    double energy = 0, peak = 0;  // J, W
};

// One phase of a block: path speed rises evenly from v0 to v1 (mm/s) in `seconds`.
inline TwinDraw phase_by_steps(const std::array<Motor, 4>& motors, const Block& block, double v0,
                               double v1, double seconds, int steps) {
    TwinDraw draw;
    if (seconds <= 0) return draw;
    for (int i = 0; i < steps; ++i) {
        double power = 0;
        for (std::size_t axis = 0; axis < 4; ++axis) {
            const double share = std::abs(block.delta[axis]) / block.length;
            const double speed = v0 + (v1 - v0) * (i + 0.5) / steps;
            power += motor_power(motors[axis], share * speed, share * (v1 - v0) / seconds);
        }
        draw.energy += power * seconds / steps;
        draw.peak = std::max(draw.peak, power);
    }
    return draw;
}

inline TwinDraw motors_by_steps(const std::array<Motor, 4>& motors, const Block& block, int steps) {
    TwinDraw sum;
    for (const TwinDraw& draw :
         {phase_by_steps(motors, block, block.v_entry, block.v_peak, block.t_accel, steps),
          phase_by_steps(motors, block, block.v_peak, block.v_peak, block.t_cruise, steps),
          phase_by_steps(motors, block, block.v_peak, block.v_exit, block.t_decel, steps)}) {
        sum.energy += draw.energy;
        sum.peak = std::max(sum.peak, draw.peak);
    }
    return sum;
}

// A thermostat that looks every dt: full power below the target, what holds it at the target.
struct SteppedBody {
    double max_power, capacity, ambient, temperature, target;

    double step(double dt, double conductance, double load) {
        const double loss = conductance * (temperature - ambient) + load;
        const double wanted = capacity * (target - temperature) / dt + loss;
        const double power = target > ambient ? std::clamp(wanted, 0.0, max_power) : 0;
        const double drain = target > ambient ? loss : loss - load;
        temperature += (power - drain) * dt / capacity;
        return power * dt;
    }
};

}  // namespace bead::test
