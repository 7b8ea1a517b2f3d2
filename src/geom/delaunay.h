// Delaunay's triangles of points, as the dual of their Voronoi diagram (Fortune's sweep, exact on
// whole numbers, by Boost.Polygon). Coordinates are rounded to a 2^-30th of the points' extent
// inside this function and nowhere else.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "geom/vec.h"

namespace bead {

// Counter-clockwise; corners are places in `points`. Where more than three points lie on one circle
// some choice of triangles is made. Points that coincide after rounding: one of them is used.
std::vector<std::array<int, 3>> delaunay(std::span<const Vec2> points);

}  // namespace bead
