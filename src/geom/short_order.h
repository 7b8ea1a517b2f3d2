// Lines in an order with little travel between them: near_order (geom/near_order.h), then stretches
// of it taken backwards as long as that makes the way shorter (2-opt, Croes 1958). For hundreds of
// lines; each pass looks at every pair.
#pragma once
#include <vector>

#include "geom/polygon.h"

namespace bead {

// Begins near `start`. Lines must not be empty; each may be turned round.
std::vector<Polyline> short_order(std::vector<Polyline> lines, Vec2 start);

// mm between the end of each line and the beginning of the next, from `start`.
double travel_between(const std::vector<Polyline>& lines, Vec2 start);

}  // namespace bead
