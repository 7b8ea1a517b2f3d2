// Loops round the first layer, at a distance from it, to prime the nozzle.
#pragma once
#include "plan/parts.h"

namespace bead {

// The outermost first; where islands are near each other one loop goes round them all.
std::vector<Polyline> skirt_round(const Region& footprint, const Bead& bead,
                                  const PlanOptions& options);

}  // namespace bead
