// The lines that fill one area.
#pragma once
#include "plan/plan.h"

namespace bead {

struct FillLines {
    std::vector<Polyline> lines;
    Bead bead;
};

// Solid. Straight lines whose distance divides the area evenly; the bead is then made as wide as
// gives the area its volume (within limits). A straight strip hardly wider than a bead has its
// lines along it instead of at `angle`.
FillLines solid_lines(const FillArea& area, double angle);

// Solid too, by the pattern of the choice, one spacing apart.
FillLines pattern_lines(const FillArea& area, const FillChoice& choice, Vec2 centre);

// `flow`: how many times the layer's bead is laid.
FillLines sparse_lines(const FillArea& area, const LayerParts& layer, const FillChoice& choice,
                       double spacing, double flow);

// Where in `patterns` it is.
std::size_t index_of(const NamedPattern& pattern);

}  // namespace bead
