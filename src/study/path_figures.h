// What a layer's path is, without time: lengths, points, turns, chord errors; and how well its
// beads cover the part. The rows that a table of shaking needs beside its responses
// (study/shaking.h).
#pragma once
#include <vector>

#include "geom/polygon.h"
#include "study/shaking.h"
#include "toolpath/path.h"

namespace bead {

// mm², to about 1 % of themselves plus half a mm²: counted on a square lattice.
struct Coverage {
    double under = 0;    // of the wall band, without a bead
    double over = 0;     // of the part, covered by a bead for the second or further time
    double outside = 0;  // of beads, beyond the part's outline
};

// `band`: mm, how far the walls should reach in from the outline; pitch of the lattice, mm.
Coverage coverage(const Toolpath& layer, const Region& outline, double band, double pitch = 0.1);

// Lengths of all, of travel, of infill with the travel that leads to it; points of G1 moves; turns
// of more than 45° at one point and within 1.5 mm of path; mean chord error r - √(r² - (l/2)²) of
// neighbouring triples of points (0 if straight).
std::vector<Figure> path_figures(const Toolpath& layer);

std::vector<Figure> figures_of(const Coverage& coverage);

}  // namespace bead
