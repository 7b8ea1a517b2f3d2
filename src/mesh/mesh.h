// A triangle mesh as plain arrays. Corners of a triangle are indices into `points`,
// counter-clockwise seen from outside.
#pragma once
#include <array>
#include <vector>

#include "geom/box.h"

namespace bead {

struct Mesh {
    std::vector<Vec3> points;                   // mm
    std::vector<std::array<int, 3>> triangles;  // indices into points
};

Box3 bounds(const Mesh& mesh);

// Enclosed volume in mm³ by the divergence theorem: exact for a closed mesh, a guess for an open
// one.
double volume(const Mesh& mesh);

// Turned by `angle` (rad, counter-clockwise) about the vertical axis, then moved by `shift`.
Mesh moved(Mesh mesh, double angle, Vec3 shift);

}  // namespace bead
