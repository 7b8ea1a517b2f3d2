// Lines that follow a direction field at a distance that may change from place to place: the level
// lines of one phase for the whole region, found at once and not line by line (stripe patterns,
// Knöppel, Crane, Pinkall and Schröder 2015). The phase grows by 2 π per spacing across the lines;
// as no phase can do so exactly, it is the one that does it best in the mean of squares: the lowest
// eigenvector of a sparse matrix with a 2 × 2 block per edge of a grid. Directions have no sign: an
// edge whose ends disagree conjugates. Where lines must begin or end the phase has a vortex, and a
// line ends there.
//
//     const std::vector<Polyline> lines = stripes(region, {along_first, spacing}, {.seed = 3});
#pragma once
#include <cstdint>
#include <vector>

#include "geom/polygon.h"
#include "infill/line_field.h"

namespace bead {

struct StripeOptions {
    double grid = 0.5;       // mm, of the vertices that know the phase
    std::uint32_t seed = 0;  // of the start vector; other seeds shift the lines
    int iterations = 8;      // inverse iterations
    double shortest = 4;     // mm; shorter lines are left out
};

// Lines may leave the region by as much as a grid cell: the caller cuts them.
std::vector<Polyline> stripes(const Region& region, const LineField& field,
                              const StripeOptions& options);

}  // namespace bead
