// A path without time: straight pieces, each from where the one before ends, with the speed asked
// for. What a time law is applied to.
#pragma once
#include <vector>

#include "geom/vec.h"
#include "toolpath/path.h"

namespace bead {

struct Piece {
    Vec2 from{}, to{};        // mm, apart
    double feed = 0;          // mm/s, above 0
    double acceleration = 0;  // mm/s², most; 0: as the law says
    double flow = 0;          // mm³ of melt per mm of way; 0: travel
};

inline double length(const Piece& piece) { return distance(piece.from, piece.to); }

// Gaps between paths are crossed in a straight line at the travel speed (mm/s).
std::vector<Piece> pieces_of(const Toolpath& toolpath, double travel_speed);

}  // namespace bead
