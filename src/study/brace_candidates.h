// Straight stretches across a structure's cells, from bead to bead.
#pragma once
#include <vector>

#include "strength/test_rig.h"
#include "study/braces.h"

namespace bead {

// Where a line crosses a bead.
struct BeadCrossing {
    Vec2 at;
    std::size_t pixel = 0;
};

// A line and its crossings, in order along it.
struct CrossedLine {
    std::vector<BeadCrossing> crossings;
};

std::vector<CrossedLine> crossed_lines(const PixelModel& model, const LoadCase& load_case,
                                       double pitch);

}  // namespace bead
