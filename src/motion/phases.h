// The three stretches of a block in which its acceleration is constant.
#pragma once
#include <array>

#include "motion/block.h"

namespace bead {

struct Phase {
    double from = 0, to = 0;  // mm along the block
    double entry = 0;         // mm/s
    double acceleration = 0;  // mm/s², negative while braking
};

// (mm/s)², at `s` mm along the block.
constexpr double squared_speed(const Phase& phase, double s) {
    return phase.entry * phase.entry + 2 * phase.acceleration * (s - phase.from);
}

// Those that the block does not have are empty.
constexpr std::array<Phase, 3> phases_of(const Block& b) {
    const double a = (b.v_entry + b.v_peak) / 2 * b.t_accel;
    const double c = a + b.v_peak * b.t_cruise;
    const double d = c + (b.v_peak + b.v_exit) / 2 * b.t_decel;
    return {Phase{0, a, b.v_entry, b.acceleration}, Phase{a, c, b.v_peak, 0},
            Phase{c, d, b.v_peak, -b.acceleration}};
}

}  // namespace bead
