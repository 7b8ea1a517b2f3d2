// Which points of a line G2 or G3 can lead through (geom/arc_recovery.h), said without its types:
// an arc of G-code is a command.
#pragma once
#include <vector>

#include "geom/polygon.h"

namespace bead {

struct FittedPiece {
    std::size_t first = 0, last = 0;  // points; one apart unless it is an arc
    bool is_arc = false;
    Vec2 centre{};
    bool clockwise = false;
};

// Pieces follow each other from the first point to the last; `tolerance` in mm.
std::vector<FittedPiece> fitted_pieces(const Polyline& line, double tolerance);

}  // namespace bead
