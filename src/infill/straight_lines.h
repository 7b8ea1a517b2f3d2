// Families of parallel lines cut by a region. Line k lies k + shift spacings from the centre. A
// line's cuts are counted by which side of it (half open) each corner lies on: an integer found
// once per corner, so that every loop is cut an even number of times whatever the rounding.
#pragma once
#include <vector>

#include "geom/along.h"
#include "infill/link.h"

namespace bead {

struct LineFamily {
    Vec2 centre;
    double angle = 0;    // rad
    double spacing = 1;  // mm
    double shift = 0;    // spacings by which the lines lie to the left of the centre
};

std::vector<CutLine> straight_lines(const std::vector<MeasuredLoop>& loops,
                                    const LineFamily& family);

// `count` families at even angles over half a turn from options.angle, so far apart that together
// they lay what one at options.spacing would; linked.
struct FillOptions;
std::vector<Polyline> crossing_lines(const Region& region, const FillOptions& options, int count,
                                     double shift);

}  // namespace bead
