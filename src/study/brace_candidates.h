// Straight stretches across a structure's cells, from bead to bead.
#pragma once
#include <vector>

#include "strength/test_rig.h"

namespace bead {

inline constexpr double soft_joints = 0.5;  // of a bar's stiffness that a stretch is counted with
inline constexpr double end_cost = 1.5;     // mm of length that its ends cost

// Where a line crosses a bead.
struct BeadCrossing {
    Vec2 at;
    std::size_t pixel = 0;
};

// A line and its crossings, in order along it.
struct CrossedLine {
    std::vector<BeadCrossing> crossings;
};

// Of a pixel's middle.
Vec2 displacement_at(const PixelGrid& grid, std::size_t pixel, const PixelVector& displacement);

std::vector<CrossedLine> crossed_lines(const PixelModel& model, const LoadCase& load_case,
                                       double pitch);

}  // namespace bead
