// Parallel lines, ends linked along the edge.
#include "infill/fill.h"
#include "infill/straight_lines.h"

namespace bead {

std::vector<Polyline> rectilinear(const Region& region, const FillOptions& options) {
    return crossing_lines(region, options, 1, 0);
}

}  // namespace bead
