// What every motor does while a block lasts, on any kinematics (machine/kinematics.h names the
// slots). Where motors follow the axes by sums and differences this is a product per motor. A
// delta's carriages do not: their speed changes on a straight line run evenly, and they may turn on
// the way.
//
// Limits are another matter, and whose they are is the firmware's choice: Klipper's hold for the
// head on every kinematics; Marlin's (speed, acceleration, classic jerk) for motors A and B of a
// CoreXY and for the towers of a delta. Blocks come with their speeds; nothing here changes them.
#pragma once
#include "geom/vec.h"
#include "machine/kinematics.h"
#include "motion/block.h"

namespace bead {

struct MotorMotion {
    double displacement = 0;  // mm, signed
    double way = 0;           // mm, back and forth added up
    double gained = 0;        // (mm/s)², ∫ a v dt while it speeds up: half of what v² gains
    double lost = 0;          // (mm/s)², ∫ |a v| dt while it slows down
    double coast = 0;         // mm of its way while the head's speed is constant
    double hold = 0;          // s: the block's time if it does not move at all, else 0
};

// Of all but a delta.
PerAxis<MotorMotion> motor_motion(Kinematics kinematics, const Block& block);

// Of a delta whose head starts over `from` (mm); all in closed form, but for the points where a
// carriage's speed is greatest or least, which are found by halving. Throws Error where the arms do
// not reach.
PerAxis<MotorMotion> motor_motion(const Delta& delta, Vec2 from, const Block& block);

}  // namespace bead
