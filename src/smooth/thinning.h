// Fewer, wider infill loops that leave no larger holes: whole loops are left out as long as every
// place of the layer stays within the same distance of a bead, and the loops that remain get the
// volume of all. The loops go one by one, once those first whose places are least worse off per mm
// that is saved, once the longest first; the way that saves more counts.
#pragma once
#include "toolpath/path.h"

namespace bead {

struct ThinningOptions {
    double void_radius = 0;  // mm; the farthest that a place may lie from the middle of a bead.
                             // 0: as far as the farthest does without thinning, to 1 %
    double nozzle = 0.4;     // mm
    double widest = 2;       // nozzles; no bead takes more room (spacing) than that
    double max_flow = 8;     // mm³/s; a wide bead is laid more slowly rather than with more
    double pitch = 0.25;     // mm, between the places that are looked at
};

// One layer whose sparse infill is closed loops of one bead, as concentric infill is; any other
// layer is left as it is.
Toolpath thinned(const Toolpath& layer, const ThinningOptions& options = {});

// The distance to the middle of the nearest bead, from the place inside the outer walls where it is
// largest, as far as a lattice of this pitch finds it. 0 where there is no outer wall.
double void_radius(const Toolpath& layer, double pitch = 0.25);

}  // namespace bead
