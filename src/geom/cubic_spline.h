// The smoothest curve through points: cubics that join with the same first and second derivative
// (C. de Boor, A Practical Guide to Splines, 1978, ch. 4). The parameter is nearly arc length:
// each chord is counted as the arc that its neighbours suggest, so a circle's points give a circle
// to the fourth power of their distance.
#pragma once
#include <array>

#include "geom/nurbs.h"

namespace bead {

// Through at least two points, no two neighbours alike; `first` and `last` are its directions at
// the ends (unit vectors).
Nurbs cubic_through(const Polyline& points, Vec2 first, Vec2 last);

// Round a loop of at least three points, of which the first is not repeated.
Nurbs closed_cubic_through(const Polyline& loop);

// One of the cubics that such a curve is made of, as Bézier's control points: the i-th, between
// points i and i + 1 (a loop's first point is repeated here).
using Cubic = std::array<Vec2, 4>;
Cubic cubic_of(const Nurbs& curve, const Polyline& points, std::size_t i);
Vec2 point_at(const Cubic& cubic, double part);

// The direction, at `here`, of the circle from `before` through `here` to `after`; and at its
// first point, of the circle from `here` through two more. Unit vectors.
Vec2 circle_direction(Vec2 before, Vec2 here, Vec2 after);
Vec2 circle_start_direction(Vec2 here, Vec2 next, Vec2 last);

}  // namespace bead
