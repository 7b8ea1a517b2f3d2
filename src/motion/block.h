// Timed motion: what a firmware's planner makes of commands. A block is one straight move with its
// trapezoid of speed; between blocks stand the commands that take effect there.
#pragma once
#include <cstdint>
#include <functional>
#include <variant>

#include "toolpath/command.h"

namespace bead {

// Speeds and acceleration are along the path (XYZ length; of the filament if it moves alone).
struct Block {
    std::int64_t line = 0;
    Role role = Role::travel;
    Bead bead;                                                  // as far as it is known
    PerAxis<double> delta{};                                    // mm, signed, in whole steps
    double length = 0;                                          // mm
    double v_nominal = 0, v_entry = 0, v_peak = 0, v_exit = 0;  // mm/s
    double acceleration = 0;                                    // mm/s²
    double t_accel = 0, t_cruise = 0, t_decel = 0;              // s
};

constexpr double duration(const Block& block) {
    return block.t_accel + block.t_cruise + block.t_decel;
}

// In the order in which the machine does it. A Dwell lasts; heaters, fans and layers change at
// once.
using MotionEvent = std::variant<Block, Dwell, SetHeat, SetFan, LayerStart>;
using MotionSink = std::function<void(const MotionEvent&)>;

}  // namespace bead
