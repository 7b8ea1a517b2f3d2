// A lane sampled so densely that its chords stray by less than a micrometre, along the curves that
// its polygon was made of where they can be found again, along its own segments elsewhere.
#pragma once
#include "smooth/ring.h"

namespace bead {

struct DenseOptions {
    bool curves = true;
    double tolerance = 0.05;  // mm, of the curve from the lane's segments
    double chord = 0.0006;    // mm, of the samples' chords from the curve
};

struct DenseLine {
    Polyline points;  // of a closed lane the first is not repeated
    std::vector<Flow> flows;
    int curves = 0;    // runs that were taken for curves
    int rejected = 0;  // smooth runs whose curve strayed too far
};

DenseLine dense_line(const Lane& lane, const DenseOptions& options);

}  // namespace bead
