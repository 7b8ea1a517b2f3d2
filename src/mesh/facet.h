// One triangle of a mesh.
#pragma once
#include "mesh/mesh.h"

namespace bead {

// Points outwards; its length is twice the triangle's area (mm²).
inline Vec3 facet_normal(const Mesh& mesh, const std::array<int, 3>& triangle) {
    const auto point = [&](int i) { return mesh.points[static_cast<std::size_t>(i)]; };
    const Vec3 a = point(triangle[0]);
    return cross(point(triangle[1]) - a, point(triangle[2]) - a);
}

// True as well for a triangle that has a point twice.
inline bool has_area(const Mesh& mesh, const std::array<int, 3>& triangle) {
    return length(facet_normal(mesh, triangle)) > 0;
}

}  // namespace bead
