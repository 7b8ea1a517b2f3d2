// Loops wound into one stroke, and the ways it may be begun.
//
// Walls: the outermost loop goes all the way round at full flow; over a link of some mm the nozzle
// then shifts to the next loop while its flow comes up from 0; from there it spirals on, and the
// last loop gets its missing mm with the flow fading. Flows add up to 1 in every lane: the
// stroke is as long as its loops and one link, its volume theirs.
// Infill: each loop ends some mm before it closes and leads obliquely on to the next, as far as
// such a link keeps clear of everything else that the layer deposits.
// Lines that do not close are strokes by themselves, begun at either end.
#pragma once
#include "smooth/ring.h"
#include "smooth/segment_grid.h"
#include "smooth/travel.h"

namespace bead {

// One way to print the stroke.
struct Winding {
    struct Turn {
        bool backward = false;  // against the ring's own direction
        double place = 0;       // mm, in that direction, where the ring is begun
    };
    std::vector<Turn> turns;  // one per ring
    StrokeEnd in, out;
    double worse = 0;  // mm of travel that would be gone to avoid it: corners under its links
};

struct Chain {
    std::vector<std::size_t> lanes;
    std::vector<Ring> rings, backward;  // of the lanes; none for an open line
    Ribbon line;                        // the open line
    bool walls = false;
    double link = 3, gap = 3;       // mm
    std::vector<Winding> windings;  // at least one
};

struct ChainOptions {
    double link = 3;  // mm, of walls; what infill loops leave open at most
    int seams = 64;   // places along the first loop, each in both directions
};

// `rings` are the lanes', nested from the first inwards.
Chain wall_chain(std::vector<std::size_t> lanes, std::vector<Ring> rings,
                 const ChainOptions& options);

Chain line_chain(std::size_t lane, Ribbon line, bool reversible);

// Rings of infill in as few chains as links allow. `spacing`: mm between neighbouring loops; `grid`
// holds every lane of the layer by its number, within a reach of `clearance` at least.
struct InfillRing {
    std::size_t lane = 0;
    Ring ring;
};
std::vector<Chain> infill_chains(std::vector<InfillRing> rings, double spacing,
                                 const SegmentGrid& grid, double clearance,
                                 const ChainOptions& options);

Ribbon wound(const Chain& chain, const Winding& winding);

}  // namespace bead
