// Where a stretch of the boundary runs: along which of the part's loops (in the order of
// measured_loops, geom/along.h), from where to where.
#pragma once
#include <optional>
#include <vector>

#include "fem/load_case.h"

namespace bead {

inline constexpr double boundary_tolerance = 0.05;  // mm, how near "on the boundary" is

// mm along the loop in its direction; from <= to, and `to` may go past the loop's length.
struct BoundarySpan {
    std::size_t loop = 0;
    double from = 0, to = 0;
};

// One span without length for a single point. Nothing if the ends are not on one loop of the
// boundary, or no boundary lies on the arc.
std::optional<std::vector<BoundarySpan>> stretch_spans(const Region& part, const Stretch& stretch);

// The same as lines; a single point comes twice.
std::optional<std::vector<Polyline>> stretch_lines(const Region& part, const Stretch& stretch);

// The stretch slid along the boundary by `distance` (mm, along the loop's direction; an arc
// counter-clockwise).
Stretch moved(const Region& part, Stretch stretch, double distance);

// How strong a load's traction is at a point, up to a factor: 1, or for a bearing the cosine of the
// angle from the force, none where it is negative.
double traction(const Load& load, Vec2 point);

}  // namespace bead
