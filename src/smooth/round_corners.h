// Corners of a ribbon rounded by curves that begin and end without curvature, each within the
// tolerance of what is deposited there and within its share of the way to the next corner. Other
// than geom's corner_blend they may begin on curves: legs are measured along the ribbon.
#pragma once
#include "smooth/ring.h"

namespace bead {

struct CornerTolerances {
    double outer_wall = 0.05, wall = 0.10, infill = 1.0;  // mm; other roles as the wall
    bool walls = true;                                    // round these too
    // 1/mm; a corner that needs more stays: it would be passed no faster than a plain one, and cost
    // points.
    double sharpest = 1000.0 / (20 * 20);
};

struct RoundedRibbon {
    Ribbon ribbon;
    int blends = 0;
};

RoundedRibbon rounded(const Ribbon& ribbon, const CornerTolerances& tolerances);

}  // namespace bead
