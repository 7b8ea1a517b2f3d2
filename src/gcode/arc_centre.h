// The centre of an arc that is told by its radius (G2 and G3 with R), as Marlin finds it.
#pragma once
#include <optional>

#include "geom/vec.h"

namespace bead {

// Relative to the start; `chord` leads from there to the end. Of the two arcs that a radius leaves
// the shorter one is meant, the longer one if the radius is negative. A radius that does not reach
// gives the half circle over the chord. Nothing if chord or radius is 0.
std::optional<Vec2> arc_centre(Vec2 chord, double radius, bool clockwise);

}  // namespace bead
