// The lines of rectilinear, each by itself: nothing is laid along the edge, and the nozzle travels
// from the end of one to the beginning of the next.
#include "infill/fill.h"
#include "infill/straight_lines.h"

namespace bead {

std::vector<Polyline> separate_lines(const Region& region, const FillOptions& options) {
    FillOptions alone = options;
    alone.link = 0;
    return crossing_lines(region, alone, 1, 0);
}

}  // namespace bead
