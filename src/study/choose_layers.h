// What to fill each layer with: every kind of layer is judged with every pattern and angle, and the
// cheapest sequence follows by dynamic programming, under two conditions: lines of neighbouring
// layers cross, and the whole weighs what the baseline weighs. The weight enters as a price on
// plastic (a Lagrange multiplier), raised until the sequence is heavy enough.
#pragma once
#include "study/candidates.h"

namespace bead {

// Share of the baseline's filament below which a choice counts as printing less.
inline constexpr double least_weight = 0.998;

// One choice per layer.
std::vector<FillChoice> best_choices(std::span<const LayerParts> placed, const Jury& jury,
                                     const Weights& weights, const OptimizeOptions& options,
                                     Effort& effort);

}  // namespace bead
