// Arcs found again in the chords that somebody made of them.
//
// A run of points becomes an arc when a circle through its first and last comes near to all of them
// and its chords are so short that the arc does not rise above them by more than a polygon's sides
// usually do (least squares for the one free number, the centre's place on the bisector). Runs are
// taken as long as they go, from the first point on.
//
//     for (const PathPiece& piece : arcs_and_lines(line, {}))
//         if (piece.arc) …  // from line[piece.first] to line[piece.last]
#pragma once
#include <optional>

#include "geom/arc.h"

namespace bead {

struct ArcOptions {
    double tolerance = 0.01;       // mm, of the points from the circle
    double rise = 0.05;            // mm, of the arc above its chords
    int least_points = 5;          // of an arc: three always lie on a circle, four easily
    double largest_radius = 1000;  // mm; flatter runs stay lines
};

// Its ends as indices of the line's points; a line from one to the next if there is no arc.
struct PathPiece {
    std::size_t first = 0, last = 0;
    std::optional<PlanarArc> arc;  // at most three quarters of a circle
};

// Pieces follow each other; the arcs' ends are the line's points to rounding.
std::vector<PathPiece> arcs_and_lines(const Polyline& line, const ArcOptions& options);

}  // namespace bead
