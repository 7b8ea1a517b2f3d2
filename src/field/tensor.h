// Symmetric tensors of the plane (stress in MPa, or strain) and their principal values. Fields keep
// and interpolate the three components, never angles: an angle jumps by half a turn where nothing
// happens.
#pragma once
#include <cmath>

#include "geom/vec.h"

namespace bead {

struct PlaneTensor {
    double xx = 0, yy = 0, xy = 0;
    bool operator==(const PlaneTensor&) const = default;
};

constexpr PlaneTensor operator+(PlaneTensor a, PlaneTensor b) {
    return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy};
}
constexpr PlaneTensor operator-(PlaneTensor a, PlaneTensor b) {
    return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy};
}
constexpr PlaneTensor operator*(double s, PlaneTensor a) { return {s * a.xx, s * a.yy, s * a.xy}; }

struct Principal {
    double first = 0, second = 0;  // first >= second
    double angle = 0;              // rad, of the first from +x, in (-pi/2, pi/2]
};

// By Mohr's circle. The angle is half an atan2, which knows which root belongs to the first value.
inline Principal principal(PlaneTensor t) {
    const double centre = (t.xx + t.yy) / 2;
    const double radius = std::hypot((t.xx - t.yy) / 2, t.xy);
    return {centre + radius, centre - radius, std::atan2(2 * t.xy, t.xx - t.yy) / 2};
}

// Huber and von Mises, with no stress across the plane.
inline double von_mises(PlaneTensor t) {
    return std::sqrt(std::max(0.0, t.xx * t.xx - t.xx * t.yy + t.yy * t.yy + 3 * t.xy * t.xy));
}

// The normal component along a unit vector.
constexpr double along(PlaneTensor t, Vec2 u) {
    return t.xx * u.x * u.x + t.yy * u.y * u.y + 2 * t.xy * u.x * u.y;
}

// The same tensor seen when everything is turned; `turn` is unit(angle).
constexpr PlaneTensor rotated(PlaneTensor t, Vec2 turn) {
    const double c = turn.x, s = turn.y;
    return {c * c * t.xx + s * s * t.yy - 2 * c * s * t.xy,
            s * s * t.xx + c * c * t.yy + 2 * c * s * t.xy,
            c * s * (t.xx - t.yy) + (c * c - s * s) * t.xy};
}

}  // namespace bead
