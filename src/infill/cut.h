// Open curves cut by a region, exactly and fast, with the place of every cut on the region's edge.
// The edges lie in horizontal bands, so that a short piece of curve meets only the few near it.
// What lies between two cuts is kept or dropped by asking whether its middle is inside: a curve
// that touches or follows the edge does no harm.
#pragma once
#include <vector>

#include "infill/fill.h"
#include "infill/link.h"

namespace bead {

std::vector<CutLine> cut_to(const std::vector<Polyline>& curves,
                            const std::vector<MeasuredLoop>& loops);

// What the patterns that are one curve do with it: cut to the region, then linked.
std::vector<Polyline> cut_and_linked(const std::vector<Polyline>& curves, const Region& region,
                                     double longest_link);

}  // namespace bead
