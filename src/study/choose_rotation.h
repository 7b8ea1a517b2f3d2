// How to turn the part: rotations on a coarse grid, then half a step to either side of the best,
// each judged on a sample of its layers with coarse angles and lines that alternate by a right
// angle.
#pragma once
#include "study/candidates.h"

namespace bead {

// The most promising ones in rad, best first, at most `count`. Rotations at which the part does not
// fit the bed are left out.
std::vector<double> promising_rotations(std::span<const LayerParts> parts, const Jury& jury,
                                        const OptimizeOptions& options, std::size_t count,
                                        Effort& effort);

}  // namespace bead
