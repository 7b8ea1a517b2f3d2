// Places along a region's edge to trace lines from, evenly apart: on every stretch between two
// corners from its middle outwards, so that a part that is its own mirror image has seeds that are.
#pragma once
#include "geom/polygon.h"

namespace bead {

struct EdgeSeed {
    Vec2 place;
    Vec2 along;  // unit vector, of the edge
};

std::vector<EdgeSeed> edge_seeds(const Region& region, double apart);

}  // namespace bead
