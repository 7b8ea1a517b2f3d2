// Three families of lines at 60°, which meet three by three: equal triangles. The plane's distances
// from a line of each family, in spacings, obey h1 + h3 = h2, so where two are whole the third is.
#include "infill/fill.h"
#include "infill/straight_lines.h"

namespace bead {

std::vector<Polyline> triangles(const Region& region, const FillOptions& options) {
    return crossing_lines(region, options, 3, 0);
}

}  // namespace bead
