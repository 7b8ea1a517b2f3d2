// The walls of one island and what they leave to be filled.
#pragma once
#include "plan/parts.h"

namespace bead {

struct Walled {
    std::vector<WallLoop> loops;  // in printing order
    Region material;              // inside the innermost wall's bead
};

// A loop is left out where its two sides would lie closer than 0.6 of a bead's spacing. Material
// narrower than half a spacing is left empty.
Walled walled(const Polygon& outline, const Bead& bead, int walls);

// The same loop, starting at its sharpest corner; of corners about as sharp, at the rearmost.
Polyline from_seam(Polyline loop);

}  // namespace bead
