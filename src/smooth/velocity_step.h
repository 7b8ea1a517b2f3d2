// What firmware lets the head's velocity step by where two chords meet; for more it brakes. Classic
// jerk counts each axis by itself. Junction deviation and square corner velocity let a corner be
// passed at v² = a d s / (1 - s), s = cos(turn / 2), which for small turns, 1 - s = turn² / 8, is a
// step of v turn = sqrt(8 a d) whatever its direction.
#pragma once
#include <limits>

#include "geom/vec.h"
#include "machine/firmware.h"
#include "machine/limits.h"

namespace bead {

struct VelocityStep {
    double x = std::numeric_limits<double>::infinity();  // mm/s, of one axis
    double y = std::numeric_limits<double>::infinity();
    double any = std::numeric_limits<double>::infinity();  // mm/s, whatever the direction

    [[nodiscard]] bool allows(Vec2 step) const {
        return std::abs(step.x) <= x && std::abs(step.y) <= y && dot(step, step) <= any * any;
    }
};

// The smallest share of its speed that is left at a corner is 1 / times.
constexpr VelocityStep operator*(double times, const VelocityStep& step) {
    return {times * step.x, times * step.y, times * step.any};
}

VelocityStep velocity_step(Firmware firmware, const Limits& limits);

}  // namespace bead
