// Places along a loop, counted in mm from its first point, and the ways between them.
//
//     const std::vector<MeasuredLoop> loops = measured_loops(region);
//     const Polyline corners = way(loops[0], 12.5, 40);   // what lies between, ends left out
#pragma once
#include <vector>

#include "geom/polygon.h"

namespace bead {

struct MeasuredLoop {
    Polyline points;         // the first is not repeated
    std::vector<double> at;  // mm, of every point
    double length = 0;       // mm, closing edge included
};

MeasuredLoop measured(Polyline loop);

// Outlines and holes of all polygons, in their order.
std::vector<MeasuredLoop> measured_loops(const Region& region);

// The loop's point at `place`, taken round as often as it takes.
Vec2 point_at(const MeasuredLoop& loop, double place);

// The loop's own points strictly between two places in [0, length), in its direction; past its
// first point when `to` comes before `from`.
Polyline way(const MeasuredLoop& loop, double from, double to);

}  // namespace bead
