// How far one line strays from another: the one-sided Hausdorff distance, largest over the points
// of `line` of the distance to `reference` (both open lines). To measure against a curve, flatten
// it first, ten times finer than what is to be measured.
#pragma once
#include <algorithm>

#include "geom/polygon.h"

namespace bead {

// mm. Corners of `line` and points between them at most `step` (mm) apart are looked at; between
// two of these it may stray farther by at most step / 2. Neither line may be empty.
double deviation(const Polyline& line, const Polyline& reference, double step = 0.1);

// Of one point from a line, and from the segment between two points.
double line_distance(const Polyline& line, Vec2 point);
double segment_distance(Vec2 a, Vec2 b, Vec2 point);

// Squared, for whoever compares very many.
inline double squared_segment_distance(Vec2 a, Vec2 b, Vec2 point) {
    const Vec2 along = b - a, to = point - a;
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0;
    const Vec2 off = to - t * along;
    return dot(off, off);
}

}  // namespace bead
