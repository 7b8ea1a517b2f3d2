// Lines with evenly spaced points, and smoother ones.
#pragma once
#include "geom/polygon.h"

namespace bead {

// Points at equal distances along the line, about `step` mm apart, ends kept.
Polyline resampled(const Polyline& line, double step);

// Each inner point moves half-way to the middle of its neighbours, `passes` times; ends stay.
Polyline smoothed(Polyline line, int passes);

// The part of a line between two places on it, mm from its start.
Polyline part_of(const Polyline& line, double from, double to);

// Moved sideways by `by` (mm, to the left) along the local normal. The line's points should be
// even.
Polyline shifted_aside(const Polyline& line, double by);

}  // namespace bead
