// Loops of infill wound into strokes: each loop ends some mm before it closes and leads obliquely
// on to the next, as far as such a link keeps clear of everything else that the layer deposits.
//
// All seams of the first loop, in both directions, are followed at once from loop to loop; the next
// is the one that most of them can be led on to, and those that cannot are dropped.
#pragma once
#include "smooth/chain.h"
#include "smooth/segment_grid.h"

namespace bead {

struct InfillRing {
    std::size_t lane = 0;
    Ring ring;
};

// What the links have to keep clear of.
struct InfillSurroundings {
    double spacing;           // mm, between neighbouring loops
    const SegmentGrid& grid;  // every lane of the layer by its number
    double clearance;         // mm, within the grid's reach
};

// In as few chains as links allow.
std::vector<Chain> infill_chains(std::vector<InfillRing> rings,
                                 const InfillSurroundings& surroundings,
                                 const ChainOptions& options);

Ribbon wound_infill(const Chain& chain, const Winding& winding);

}  // namespace bead
