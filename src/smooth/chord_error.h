// How far what is deposited lies from the curves that it stands for: the honest row beside Eq. 31,
// which knows no curve (metrics.h).
#pragma once
#include <span>

#include "geom/polygon.h"
#include "toolpath/path.h"

namespace bead {

// mm: the largest distance from the paths of this role to the nearest curve (one-sided Hausdorff).
// Looked at every 0.1 mm. Curves are open lines, flattened ten times finer than what is measured;
// a loop repeats its first point. No answer (0) without paths of the role; expects a curve.
double chord_error(const Toolpath& layer, Role role, std::span<const Polyline> curves);

// The boundary of a region, closed, as curves.
std::vector<Polyline> boundary_curves(const Region& region);

}  // namespace bead
