// The chords that Marlin makes of a cubic Bézier curve (G5). It steps along the parameter, halving
// the step while the curve's middle strays from the chord's by more than 0.1 mm (|x| + |y|), else
// doubling it while it does not: steps of 0.001 to 0.2, so a curve has at most 1000 chords. The
// parameter is counted in single precision, as in the firmware, so that the chords are the same.
#pragma once
#include <array>
#include <vector>

#include "geom/vec.h"

namespace bead {

struct CurvePoint {
    Vec2 at;
    double share = 0;  // of the curve's parameter, 0 … 1
};

// Ends of the chords, the last one at control[3].
std::vector<CurvePoint> curve_chords(const std::array<Vec2, 4>& control);

}  // namespace bead
