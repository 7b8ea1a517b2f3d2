// What to fill each layer with: every kind of layer is judged with every pattern and angle, and the
// cheapest sequence follows by dynamic programming, with one condition: lines of neighbouring
// layers cross, so that layers hold each other.
#pragma once
#include "study/candidates.h"

namespace bead {

// One choice per layer.
std::vector<FillChoice> best_choices(std::span<const LayerParts> placed, const Jury& jury,
                                     const OptimizeOptions& options, Effort& effort);

}  // namespace bead
