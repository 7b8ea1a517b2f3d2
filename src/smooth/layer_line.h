// A layer as the one line that the nozzle draws, travel included, for measures that do not care
// where one path ends and the next begins.
#pragma once
#include <vector>

#include "geom/polygon.h"
#include "toolpath/path.h"

namespace bead {

struct LayerLine {
    Polyline points;           // no two in a row are one place; z is not looked at
    std::vector<Role> roles;   // of the segments, one less than points
    std::vector<Role> phases;  // of the segments: of travel the role of what it leads to
};

// A gap between two paths counts as travel. Travel after the last deposit is its own phase.
LayerLine line_of(const Toolpath& layer);

// Without the segments shorter than `least` (mm): their ends are one place. The first point stays.
Polyline without_short_segments(const Polyline& line, double least);

}  // namespace bead
