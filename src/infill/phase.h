// The phase that grows as stripes.h asks, best in the mean of squares: one angle per vertex.
#pragma once
#include <cstdint>
#include <vector>

#include "infill/stripe_grid.h"

namespace bead {

// rad, in (-π, π], each in its own vertex's direction. The smallest eigenvector of
// Σ |ψ_j - R_ij ψ_i|² by inverse iteration from a random start.
std::vector<double> best_phase(const StripeGrid& grid, std::uint32_t seed, int iterations);

}  // namespace bead
