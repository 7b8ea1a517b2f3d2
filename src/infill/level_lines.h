// Where the phase of a grid's vertices is a whole number of turns, as lines.
#pragma once
#include <span>
#include <vector>

#include "geom/polygon.h"
#include "infill/stripe_grid.h"

namespace bead {

// Unwrapped triangle by triangle by what the phase should do along its edges; a triangle round
// which that does not add up holds a vortex, and lines end there. Closed lines repeat their first
// point.
std::vector<Polyline> level_lines(const StripeGrid& grid, std::span<const double> phase);

}  // namespace bead
