// The curves that the polygons of walls stand for, as far as they are found again.
#pragma once
#include <vector>

#include "geom/polygon.h"

namespace bead::cli {

// Of loops whose first point is not repeated; fine polygons, closed stretch by stretch.
std::vector<Polyline> outline_curves(const std::vector<Polyline>& loops);

}  // namespace bead::cli
