// The part's section as the outer walls of a layer have it: what G-code tells of the model.
#pragma once
#include "geom/polygon.h"
#include "smooth_file.h"
#include "smooth_rows.h"

namespace bead::cli {

// Coverage of the walls and how far they lie from the curves that their polygons stand for, of both
// sides by the outline that is told before: the outer walls' edges. Nothing without closed outer
// walls.
void add_coverage(const LayerPair& layer, PathFigures& before, PathFigures& after);

}  // namespace bead::cli
