// What every design of a part has alike: walls along its outline and holes, and solid pads where
// loads and supports take hold.
#pragma once
#include "study/layout.h"

namespace bead {

inline constexpr double bead_overlap = 0.1;  // mm, by which neighbouring solid beads overlap

// The stretches of the boundary where loads, all along their ranges, and supports are.
std::vector<Polyline> patches_of(const LoadCase& load_case);

// Beads along all boundaries, the first half a width inside.
Layout wall_lines(const Region& part, double bead_width, int walls);

// As many beads deep as `depth` beside each stretch that is loaded or held, and a millimetre longer
// than it; those that a wall already is are left out.
Layout pad_lines(const LoadCase& load_case, int walls, int depth = 3);

}  // namespace bead
