// Points on a curve, each at the same straight distance from the one before, as a machine that is
// sent a point per period needs them to run at an even speed.
//
// The next parameter is foretold by Taylor's second order, u + L/|C'| - (C'·C'') L² / (2 |C'|⁴),
// and corrected by Newton's steps on the chord's length (with its second derivative: Halley's);
// where such a step leaves the stretch that is known to hold the answer, it is halved instead.
// There is one answer as long as L is less than twice the least radius of curvature. The last
// chord, to the curve's end, is shorter.
//
//     const ChordWalk walk = equal_chords(curve, 0.5);
//     const double uneven = speed_fluctuation(walk.points, 0.5);   // below 1e-6
#pragma once
#include "geom/nurbs.h"

namespace bead {

struct ChordOptions {
    double tolerance = 1e-7;  // of the chord's length, where steps stop
    int most_steps = 60;      // to correct a point; 0: as foretold
};

struct ChordWalk {
    Polyline points;                 // the curve's ends included
    std::vector<double> parameters;  // of each
    std::vector<int> steps;          // that each took to be corrected
};

// `chord` in mm, above 0.
ChordWalk equal_chords(const Nurbs& curve, double chord, const ChordOptions& options = {});

// The largest |1 - distance / chord| between neighbours, the last pair left out.
double speed_fluctuation(const Polyline& points, double chord);

}  // namespace bead
