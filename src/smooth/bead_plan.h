// Fewer, wider wall beads for the same wall: behind each outer wall, which stays as it is, every
// two neighbouring inner loops become one half-way between them that deposits the volume of both.
// A slicer's change rather than smoothing, so it is reported beside a baseline that has it too.
#pragma once
#include "toolpath/path.h"

namespace bead {

struct BeadPlanOptions {
    double nozzle = 0.4;  // mm
    double widest = 2;    // nozzles; no bead takes more room (spacing) than that
    double max_flow = 8;  // mm³/s; a wide bead is laid more slowly rather than with more
};

// One layer. Loops are left alone where two of them are not side by side all the way round (in
// necks, where one ends and the other goes on), where the bead would be too wide, or where it would
// have to go so slowly that nothing is gained.
Toolpath bead_planned(const Toolpath& layer, const BeadPlanOptions& options = {});

}  // namespace bead
