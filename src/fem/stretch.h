// Where a stretch of the boundary runs: as lines along the part's outline and holes.
#pragma once
#include <optional>
#include <vector>

#include "fem/load_case.h"

namespace bead {

inline constexpr double boundary_tolerance = 0.05;  // mm, how near "on the boundary" is

// The lines in the direction of the part's loops; a single point twice for a stretch without
// length. Nothing if its ends are not on one loop of the boundary, or no boundary lies on its arc.
std::optional<std::vector<Polyline>> stretch_lines(const Region& part, const Stretch& stretch);

// The stretch slid along the boundary by `distance` (mm, along the loop's direction; an arc
// counter-clockwise).
Stretch moved(const Region& part, Stretch stretch, double distance);

// How strong a load's traction is at a point, up to a factor: 1, or for a bearing the cosine of the
// angle from the force, none where it is negative.
double traction(const Load& load, Vec2 point);

}  // namespace bead
