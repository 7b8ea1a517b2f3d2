// Fewer points for the same shape (Douglas and Peucker 1973): no point that is dropped lies farther
// than `tolerance` (mm) from the line that is kept. Ends and order are kept.
#pragma once
#include "geom/polygon.h"

namespace bead {

Polyline simplified(const Polyline& line, double tolerance);
Polyline simplified_loop(const Polyline& loop, double tolerance);  // may return fewer than 3 points
Region simplified(const Region& region, double tolerance);         // drops loops that vanish

}  // namespace bead
