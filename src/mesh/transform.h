// An affine map of space: where the unit vectors and the origin go.
#pragma once
#include "geom/vec.h"

namespace bead {

struct Transform {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin;

    [[nodiscard]] Vec3 linear(Vec3 p) const { return p.x * x + p.y * y + p.z * z; }
    [[nodiscard]] Vec3 of(Vec3 p) const { return linear(p) + origin; }
    [[nodiscard]] double determinant() const { return dot(x, cross(y, z)); }
    // First `inner`, then this one.
    [[nodiscard]] Transform after(const Transform& inner) const {
        return {linear(inner.x), linear(inner.y), linear(inner.z), of(inner.origin)};
    }
};

}  // namespace bead
