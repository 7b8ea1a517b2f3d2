// Sums, differences and offsets of regions, and lines cut by regions, by the Clipper library
// (A. Johnson, after B. Vatti 1992). Clipper counts in whole numbers: coordinates are rounded to
// 1 nm inside these functions and nowhere else. Results are clean: outlines counter-clockwise,
// holes clockwise, polygons disjoint;
// pieces below 1e-4 mm² are left out.
#pragma once
#include <vector>

#include "geom/polygon.h"

namespace bead {

Region united(const Region& a, const Region& b);
Region intersection(const Region& a, const Region& b);
Region difference(const Region& a, const Region& b);

// How crossing or nested loops make a region: `even_odd` ignores their direction, `positive` keeps
// what is wound round at least once counter-clockwise.
enum class FillRule { even_odd, positive };
Region region_of(const std::vector<Polyline>& loops, FillRule rule);

// What the region becomes when its boundary moves outwards by `distance` (mm; negative: inwards).
enum class Corner { miter, round };
Region offset(const Region& region, double distance, Corner corner = Corner::miter);

// Shrunk and grown again by `radius`: parts narrower than twice that are gone.
Region opened(const Region& region, double radius);

// What bands along lines cover, together: straight across at the ends of an open line, corners
// mitred, or both round; a line that ends where it began is a closed band.
struct WideLine {
    Polyline points;
    double width = 0;  // mm
};
Region covered_by(const std::vector<WideLine>& lines, Corner corner = Corner::miter);

// The parts of open lines that lie inside (or outside) the region. Clipper's order is not kept.
std::vector<Polyline> inside_parts(const std::vector<Polyline>& lines, const Region& region);
std::vector<Polyline> outside_parts(const std::vector<Polyline>& lines, const Region& region);

}  // namespace bead
