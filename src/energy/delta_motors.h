// What the motors of a linear delta draw during a block above standing still: the same law as in
// energy/motors.h, power = per_speed |wᵢ| + max(0, τᵢ wᵢ) / efficiency for each tower, with
//     τᵢ = Fᵢ sign(wᵢ) + mᵢ (dwᵢ/dt + g) + (share of the head's force m (a + g ẑ))ᵢ
// Fᵢ is the friction of a carriage on its rail, mᵢ what it moves by itself (carriage, belt, rotor),
// m the head's mass. The head's force is shared among the arms by Jᵀ τ = F, J being how fast each
// carriage goes per mm/s of the head. Weight counts, as carriages go up and down on a level line;
// what a falling carriage gives is lost.
//
// On a delta the work depends on the place, so it is not the same after a translation.
#pragma once
#include "energy/motors.h"
#include "geom/vec.h"

namespace bead {

// The head starts over `from` (mm). By quadrature, to some 10⁻⁶ J a block and 10⁻⁷ of a print. The
// peak is that of the ends of phases and the points of the quadrature. Throws Error where the arms
// do not reach.
MotorDraw delta_draw(const std::array<Motor, 4>& motors, const Delta& delta, Vec2 from,
                     const Block& block);

}  // namespace bead
