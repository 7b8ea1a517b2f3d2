#include "gcode/arc_fit.h"

#include "geom/arc_recovery.h"

namespace bead {

std::vector<FittedPiece> fitted_pieces(const Polyline& line, double tolerance) {
    std::vector<FittedPiece> pieces;
    if (line.size() < 2) return pieces;
    for (const PathPiece& piece : arcs_and_lines(line, {.tolerance = tolerance})) {
        if (piece.arc)
            pieces.push_back(
                {piece.first, piece.last, true, piece.arc->centre, piece.arc->sweep < 0});
        else
            pieces.push_back({piece.first, piece.last, false, {}, false});
    }
    return pieces;
}

}  // namespace bead
