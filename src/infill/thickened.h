// Lines made thicker where they carry much: copies beside them, a bead apart, one more on either
// side for every multiple of a threshold that is exceeded. Copies are moved along the local normal,
// so that they stay at their distance where a line bends.
#pragma once
#include <functional>

#include "geom/polygon.h"

namespace bead {

struct ThickenOptions {
    double threshold = 1;  // in the load's unit
    int copies = 4;        // on either side, at most
    double apart = 0.5;    // mm
    double shortest = 2;   // mm, of copies; shorter gaps between two are closed
    Region inside;         // copies are cut to it
};

// The copies alone. `load`: what a line carries at a place.
std::vector<Polyline> thickening(const Polyline& line, const std::function<double(Vec2)>& load,
                                 const ThickenOptions& options);

}  // namespace bead
