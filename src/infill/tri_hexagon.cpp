// The lines of triangles, each family moved by half its spacing: then lines meet only two by two,
// half-way between those of the third family, and bound hexagons with a triangle on every side.
#include "infill/fill.h"
#include "infill/straight_lines.h"

namespace bead {

std::vector<Polyline> tri_hexagon(const Region& region, const FillOptions& options) {
    return crossing_lines(region, options, 3, 0.5);
}

}  // namespace bead
