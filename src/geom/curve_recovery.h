// Smooth curves found again in the polygons that somebody made of them: where a line turns little
// from chord to chord and its chords are of like lengths, it is taken for a curve and a cubic is
// laid through its points, tangent to the straight lines at its ends. A cubic that leaves the
// polygon by more than the tolerance is not believed.
#pragma once
#include <optional>

#include "geom/nurbs.h"

namespace bead {

struct RecoveryOptions {
    double corner = 26 * pi / 180;  // rad, a point that turns by more is a corner
    double ratio = 3;               // a chord more than so many times its neighbour is a line
    double tolerance = 0.06;        // mm, of the curve from the polygon
};

// A stretch between two corners or ends of lines. `points` are the line's own, both ends included;
// without a curve they are what is known.
struct RecoveredRun {
    Polyline points;
    std::optional<Nurbs> curve;
};

// Runs follow each other. Points must differ from their neighbours.
std::vector<RecoveredRun> recovered_runs(const Polyline& line, const RecoveryOptions& options);

// Of a loop whose first point is not repeated; one run that ends where it begins if it is smooth
// all round, otherwise beginning at a corner.
std::vector<RecoveredRun> recovered_loop(const Polyline& loop, const RecoveryOptions& options);

}  // namespace bead
