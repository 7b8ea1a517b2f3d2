// Loops wound into one stroke, and the ways it may be begun.
//
// Nested walls: wall_chain.h. Loops of infill: infill_chain.h.
// Lines that do not close are strokes by themselves, begun at either end.
#pragma once
#include <optional>

#include "smooth/ring.h"
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
    double link = 3;                // mm, of walls; what infill loops leave open at most
    int seams = 64;                 // places along the first loop, each in both directions
    std::optional<Vec2> seam = {};  // the only one of a chain of walls
};

Chain line_chain(std::size_t lane, Ribbon line, bool reversible);

Ribbon wound(const Chain& chain, const Winding& winding);

}  // namespace bead
