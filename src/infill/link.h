// Lines that end on the edge of their region, and how they become few long ones: two ends that
// follow each other on the edge are joined along it. Every piece of edge is used at most once.
#pragma once
#include <vector>

#include "geom/along.h"

namespace bead {

// Where on the region's edge a line ends: which of its loops, and mm along it.
struct EdgePlace {
    int loop = -1;  // -1: nowhere, the line ends inside
    double at = 0;
};

struct CutLine {
    Polyline points;
    EdgePlace start, end;
};

// Shorter lines are not worth a move.
inline constexpr double shortest_line = 1e-3;  // mm

// `loops` are those of the region. Ends farther apart than `longest` (mm, along the edge) stay
// apart. Of two neighbours the nearer is taken; the order of the lines decides where to begin, and
// neighbouring lines in order give the longest chains. The result goes from near to near.
std::vector<Polyline> linked(const std::vector<CutLine>& lines,
                             const std::vector<MeasuredLoop>& loops, double longest);

}  // namespace bead
