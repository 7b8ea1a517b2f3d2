// How fast each point of a path may be passed.
//
// Real corners, and all points under a trapezoid: square corner velocity (motion/corner.h). Points
// that a jerk-limited law takes for parts of a smooth bend (they turn by less than 20.5°): the
// centripetal acceleration of the bend, its curvature seen over 1.5 mm, so that fine chords are not
// braked for; at coarse ones the velocity may step by no more than the law's bound,
// v <= dv/(2 sin(θ/2)).
#pragma once
#include <span>
#include <vector>

#include "vibration/piece.h"
#include "vibration/time_law.h"

namespace bead {

// Of n pieces n + 1, in mm/s; the ends are 0.
std::vector<double> point_speeds(std::span<const Piece> pieces, const TimeLaw& law);

// mm/s², the smaller of what piece and law allow.
double acceleration_of(const Piece& piece, const TimeLaw& law);

// rad/mm at the n + 1 points: what the path turns by within half the window on either side.
std::vector<double> windowed_curvature(std::span<const Piece> pieces, double window);

}  // namespace bead
