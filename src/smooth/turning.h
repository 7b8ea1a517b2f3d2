// Where a line turns. Two counts, because the plain one is easily fooled: a fillet of 0.1 mm takes
// the turning point away and leaves the machine the same jolt.
//
// Turning point: the angle between two segments in a row exceeds a limit (Eq. 26 of the paper that
// docs/smoothing.md discusses). Windowed: somewhere within `window` mm of line the heading changes
// by more than the limit; places closer together than the window are one.
#pragma once
#include "geom/polygon.h"

namespace bead {

// The turn at every point but the first and last, rad in (-pi, pi], to the left positive. No two
// points in a row may be one place.
std::vector<double> turns(const Polyline& line);

// How many of them are larger.
int sharper_than(const std::vector<double>& turns, double limit);
int turning_points(const Polyline& line, double limit);

int windowed_turning_points(const Polyline& line, const std::vector<double>& turns, double limit,
                            double window = 1);
int windowed_turning_points(const Polyline& line, double limit, double window = 1);

}  // namespace bead
