// Curves that round a corner of a path and stray from it by no more than told.
//
// The smooth one is a quintic Bézier curve of six control points on the two legs, at
// leg · {1, 1 - k, 1 - 2k} from the corner and mirrored: three on a line at each end, so curvature
// begins and ends at 0 (G2). It passes the corner at leg (16 - 25k) / 16 · sin(θ/2), θ being the
// turn; k is what makes its peak curvature least, to 1 %. The plain one is an arc: 4 % less peak
// curvature, but all of it at once.
//
//     const auto blend = corner_blend(a, corner, b, {.deviation = 0.05, .longest_leg = 3});
#pragma once
#include <array>
#include <optional>

#include "geom/nurbs.h"

namespace bead {

struct BlendOptions {
    double deviation = 0.05;   // mm between corner and blend, at most
    double longest_leg = 1e9;  // mm of each leg that may be cut off
};

struct CornerBlend {
    std::array<Vec2, 6> points;
    double leg = 0;        // mm cut off each side
    double deviation = 0;  // mm
};

// Only the directions of `before` and `after` matter: whether the legs are that long is for
// `longest_leg` to say. None for a turn below 0.01° or above 179°.
std::optional<CornerBlend> corner_blend(Vec2 before, Vec2 corner, Vec2 after,
                                        const BlendOptions& options);

Vec2 point_at(const CornerBlend& blend, double part);  // 0 … 1
double length(const CornerBlend& blend);               // mm, to 1e-9 of it
double peak_curvature(const CornerBlend& blend);       // 1/mm
Nurbs nurbs_of(const CornerBlend& blend);

struct ArcBlend {
    PlanarArc arc;
    double leg = 0, deviation = 0;  // mm
};
std::optional<ArcBlend> arc_blend(Vec2 before, Vec2 corner, Vec2 after,
                                  const BlendOptions& options);

}  // namespace bead
