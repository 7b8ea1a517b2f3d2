// How to turn the part: rotations on a coarse grid, then half a step to either side of the best,
// each judged on a sample of its layers with coarse angles and lines that alternate by a right
// angle.
#pragma once
#include "study/candidates.h"

namespace bead {

// rad. Rotations at which the part does not fit the bed are left out.
double best_rotation(std::span<const LayerParts> parts, const Jury& jury, const Weights& weights,
                     const OptimizeOptions& options, Effort& effort);

}  // namespace bead
