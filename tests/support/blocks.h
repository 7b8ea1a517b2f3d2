// Blocks made by hand from the closed form of a trapezoid, without a planner.
#pragma once
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "motion/block.h"

namespace bead::test {

// A straight move of `delta` (mm) from speed v0 to v1 (mm/s), at most v (mm/s), with acceleration a
// (mm/s²). v0 and v1 must be within reach of each other over the length.
inline Block trapezoid(const PerAxis<double>& delta, double v0, double v1, double v, double a) {
    Block block;
    block.delta = delta;
    block.length = std::hypot(delta[axis_x], delta[axis_y], delta[axis_z]);
    if (block.length <= 0) block.length = std::abs(delta[axis_e]);
    block.v_nominal = v;
    block.v_entry = v0;
    block.v_exit = v1;
    block.acceleration = a;
    block.v_peak = std::min(v, std::sqrt(a * block.length + (v0 * v0 + v1 * v1) / 2));
    const double up = (block.v_peak * block.v_peak - v0 * v0) / (2 * a);
    const double down = (block.v_peak * block.v_peak - v1 * v1) / (2 * a);
    block.t_accel = (block.v_peak - v0) / a;
    block.t_cruise = std::max(0.0, block.length - up - down) / block.v_peak;
    block.t_decel = (block.v_peak - v1) / a;
    return block;
}

// A number between low and high, in steps of a millionth of the range, from RapidCheck's seed.
inline double number_between(double low, double high) {
    return low +
           (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1000001)) / 1e6;
}

// Any block: triangle or trapezoid, along any axes, from and to any speeds that it allows.
inline Block any_block() {
    const auto moved = [] { return *rc::gen::inRange(0, 4) == 0 ? 0.0 : number_between(-20, 20); };
    const PerAxis<double> delta{moved(), moved(), number_between(0.01, 1), number_between(-1, 2)};
    const double v = number_between(1, 200), a = number_between(100, 5000);
    Block block = trapezoid(delta, 0, 0, v, a);
    const double v0 = number_between(0, block.v_peak), v1 = number_between(0, block.v_peak);
    block = trapezoid(delta, v0, v1, v, a);
    block.role = static_cast<Role>(*rc::gen::inRange(0, 9));
    return block;
}

}  // namespace bead::test
