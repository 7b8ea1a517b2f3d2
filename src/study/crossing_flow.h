// Where a bead crosses one that is there already, the plastic is double. It may be laid with less
// of its section there: the beads in compression, within a bead's width of where they cross those
// in tension, which are laid first (Uncu 2023 names Sales's study of it).
#pragma once
#include "study/layout.h"

namespace bead {

struct FlowPart {
    Polyline points;
    double flow = 1;  // share of the bead's section
};

// The line in its order, each part beginning where the one before ends. `places`: mm along it,
// rising; `reach`: mm to either side of each.
std::vector<FlowPart> flow_parts(const Polyline& line, const std::vector<double>& places,
                                 double reach, double flow);

// The lines of a kind, each in its parts: of compression by print.crossing_flow, others whole.
std::vector<std::vector<FlowPart>> flow_parts(const std::vector<Polyline>& lines, LineKind kind,
                                              const std::vector<Polyline>& tension,
                                              const PrintWish& print);

}  // namespace bead
