// One section as a plain slicer lays it: wall loops one bead apart, concentric infill, each loop
// begun at the corner nearest to where the nozzle is, always on to the nearest loop. What smoothing
// is compared with.
#pragma once
#include "geom/polygon.h"
#include "toolpath/path.h"

namespace bead {

struct SectionOptions {
    int walls = 3;
    Bead bead{0.4 + 0.2 * (1 - pi / 4), 0.2};  // mm; such beads tile the wall 0.4 mm apart
    double infill_spacing = 4.5;  // mm; the first loop lies half of it inside the walls
    double wall_speed = 50, infill_speed = 60, travel_speed = 120;  // mm/s
    double least_infill = 0.5;  // mm²; smaller infill loops are left out
};

// Walls first, then infill, from 5 mm beside the lower left corner; z is the bead's height.
Toolpath sliced_section(const Region& section, const SectionOptions& options = {});

// The layer's loops put in that order anew, walls before infill: for a layer whose loops changed.
Toolpath greedily_ordered(const Toolpath& layer);

}  // namespace bead
