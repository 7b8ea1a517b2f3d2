// Fewer, wider wall beads for the same wall: behind each outer wall, which stays as it is, every
// two neighbouring inner loops become one half-way between them that deposits the volume of both.
// Where the third loops of several holes have grown together, their volume goes to the second ones.
// A slicer's change rather than smoothing, so it is reported beside a baseline that has it too.
#pragma once
#include "toolpath/path.h"

namespace bead {

struct BeadPlanOptions {
    double nozzle = 0.4;  // mm
    double widest = 2;    // nozzles; no bead takes more room (spacing) than that
    double max_flow = 8;  // mm³/s; a wide bead is laid more slowly rather than with more
};

// One layer. Loops are left alone where wide ones would overlap, be too wide or have to go so
// slowly that nothing is gained.
Toolpath bead_planned(const Toolpath& layer, const BeadPlanOptions& options = {});

}  // namespace bead
