// How motors move the head. Motors are kept in the slots of the axes that they are named after, so
// that any table per axis is one per motor too; the last one is always the extruder's.
//
//     cartesian   X, Y, Z      each motor has an axis of its own
//     corexy      A, B, Z      A = X + Y, B = X - Y    (mm of belt)
//     corexz      A, Y, B      A = X + Z, B = X - Z
//     delta       A, B, C      heights of three carriages on towers at 210°, 330° and 90°
#pragma once
#include <cstdint>

namespace bead {

enum class Kinematics : std::uint8_t { cartesian, corexy, corexz, delta };

// A linear delta: every carriage holds the head by arms of one length. X = Y = 0 is in the middle
// of its round bed.
struct Delta {
    double arm = 333;        // mm, from joint to joint
    double radius = 175;     // mm, between an arm's two joints seen from above, head in the middle
    double head_mass = 0.3;  // kg, of all that hangs on the arms, a third of these included
};

}  // namespace bead
