// What motors draw during a block above standing still. Per axis, with v its speed, m its mass, a
// its acceleration and F its friction:
//     power = per_speed |v| + max(0, (F ± m a) v) / efficiency      (+ speeding up, - braking)
// so moving energy covers friction while braking and none of it comes back to the supply.
// Acceleration is constant in each phase of a block, which makes every integral a product.
#pragma once
#include "machine/power.h"
#include "motion/block.h"

namespace bead {

struct MotorDraw {
    double xy = 0;    // J, of X and Y
    double all = 0;   // J, of all four
    double peak = 0;  // W, all four at the dearest instant
};

MotorDraw motor_draw(const std::array<Motor, 4>& motors, const Block& block);

}  // namespace bead
