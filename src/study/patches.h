// More bead where a structure would break first: second beads beside lines, and bars from bead to
// bead. Which help is not where the stress is highest but what the sensitivity says: load can be
// led away from a hot spot by a bead some way off. Taken are those that promise most per length.
#pragma once
#include <span>

#include "strength/sensitivity.h"
#include "study/layout.h"

namespace bead {

struct PatchLineOptions {
    double area = 5;          // mm² of bead that may be spent, one patch may exceed it
    double most_area = 8;     // mm², and that only as far as this
    int most = 9;             // patches
    int skipped = 0;          // best ones to leave out, for they were tried
    double pitch = 1.5;       // mm, between parallel bars
    double shortest_bar = 2;  // mm
    double longest = 35;      // mm
};

// `tested` and `adjoint`: of the layout. Nothing where nothing promises to help.
Layout patches(const Layout& layout, const TestRig& rig, std::span<const Tested> tested,
               std::span<const PixelVector> adjoint, const LoadCase& load_case,
               const PatchLineOptions& options);

}  // namespace bead
