// Lines put in an order, and turned round where that helps, so that the way from each to the next
// is short: always on to the nearest end that is left. Fast for thousands of lines.
#pragma once
#include <vector>

#include "geom/polygon.h"

namespace bead {

// Begins with the line whose end is nearest to `start`. Lines must not be empty.
std::vector<Polyline> near_order(std::vector<Polyline> lines, Vec2 start);

}  // namespace bead
