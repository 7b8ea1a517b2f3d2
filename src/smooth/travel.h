// Travel from the end of one stroke to the start of the next: an arc, a straight line, an arc, so
// that the nozzle enters and leaves in the direction of travel. Where that is a long way round, as
// between the ends of neighbouring lines, straight across, which costs stops.
#pragma once

#include "geom/dubins.h"

namespace bead {

// Where a stroke begins or ends; the unit vector of its direction there.
struct StrokeEnd {
    Vec2 at, along;
};

// `widest`: the radius of turns, mm; over short ways it is less, down to a quarter.

// mm; straight travel counts more than it is long, by `stop_cost` radii.
double travel_cost(const StrokeEnd& from, const StrokeEnd& to, double widest);

// Dense points, both ends included.
struct TravelLine {
    Polyline points;
    bool straight = false;
};
TravelLine travel_line(const StrokeEnd& from, const StrokeEnd& to, double widest);

}  // namespace bead
