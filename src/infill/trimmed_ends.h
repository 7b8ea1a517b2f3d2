// Free ends cut off: a line that ends in the void carries nothing from its last joint on. Each line
// is cut back to its first and last contact with a line of another family or with a wall or pad.
#pragma once
#include <span>
#include <vector>

#include "geom/polygon.h"

namespace bead {

struct FamilyLine {
    int family = 0;
    Polyline points;
};

struct TrimOptions {
    double contact = 0.35;  // mm, between centre lines, that counts as a joint
    double shortest = 3;    // mm; what is left of a line must be as long
    int passes = 3;         // each may set free what leant on the one before
};

std::vector<FamilyLine> trimmed_ends(std::vector<FamilyLine> lines, std::span<const Polyline> fixed,
                                     const TrimOptions& options);

}  // namespace bead
