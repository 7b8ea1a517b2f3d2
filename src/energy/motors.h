// What motors draw during a block above standing still. With wₘ the speed of motor m and τₘ the
// force that it gives at its belt:
//     power = Σ over motors of  per_speed |wₘ| + max(0, τₘ wₘ) / efficiency
// A motor that stands loses nothing to speed; one that is pulled along gives nothing back.
//
// The forces come from the axes. Along each axis, with v its speed, a its acceleration, F the
// friction of its rails and M all that moves along it,
//     f = F sign(v) + M a
// whatever the kinematics: friction and moving energy are the head's, not the motors'. A motor of a
// cartesian axis takes all of it. On a CoreXY with A = X + Y, B = X - Y both pull:
//     τA = (fx + fy) / 2,  τB = (fx - fy) / 2,  so that  τA wA + τB wB = fx vx + fy vy.
// Along a diagonal one motor stands and the other does all the work. Where the axes' masses or
// frictions differ, one motor may pull the other along: that power is lost. While braking, moving
// energy covers friction and none of it comes back to the supply.
// Acceleration is constant in each phase of a block, which makes every integral a product.
#pragma once
#include "machine/kinematics.h"
#include "machine/power.h"
#include "motion/block.h"

namespace bead {

struct MotorDraw {
    PerAxis<double> speed{}, work{};  // J by motor: the two terms above
    PerAxis<bool> turns{};
    double peak = 0;  // W, all four at the dearest instant
};

// J.
constexpr double total(const MotorDraw& draw) {
    double sum = 0;
    for (std::size_t slot = 0; slot < draw.work.size(); ++slot)
        sum += draw.speed[slot] + draw.work[slot];
    return sum;
}

// Whether the motor in that slot turns when the head moves in X and Y.
constexpr bool turns_in_xy(Kinematics kinematics, std::size_t slot) {
    const bool shares_z = kinematics == Kinematics::corexz || kinematics == Kinematics::delta;
    return slot <= axis_y || (slot == axis_z && shares_z);
}

// J of it, of the motors that moves in X and Y turn.
constexpr double xy_part(const MotorDraw& draw, Kinematics kinematics = Kinematics::cartesian) {
    double sum = 0;
    for (std::size_t slot = 0; slot < draw.work.size(); ++slot)
        if (turns_in_xy(kinematics, slot)) sum += draw.speed[slot] + draw.work[slot];
    return sum;
}

// Of all but a delta (energy/delta_motors.h).
MotorDraw motor_draw(const std::array<Motor, 4>& motors, const Block& block,
                     Kinematics kinematics = Kinematics::cartesian);

}  // namespace bead
