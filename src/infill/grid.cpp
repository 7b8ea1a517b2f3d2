// Two families of lines at right angles in every layer: squares. Where lines cross, two beads are
// laid in one place.
#include "infill/fill.h"
#include "infill/straight_lines.h"

namespace bead {

std::vector<Polyline> grid(const Region& region, const FillOptions& options) {
    return crossing_lines(region, options, 2, 0);
}

}  // namespace bead
