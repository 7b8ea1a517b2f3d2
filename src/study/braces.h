// Short ties that hold a structure where it would buckle. Quads of two crossing families fold; what
// matters is where the few diagonals sit, and only the modes know that. Each candidate is a
// straight stretch from bead to bead; in the space of the lowest modes it adds the stiffness that
// it would have as a bar, and those are taken, one after the other, that lift the load factors most
// for their length.
#pragma once
#include <vector>

#include "strength/test_rig.h"
#include "study/layout.h"

namespace bead {

struct BraceOptions {
    double area = 10;                     // mm² of bead that may be spent
    double over = 6;                      // mm by which the last brace may exceed the area
    int most = 8;                         // braces
    double shortest = 2.5, longest = 26;  // mm
    int cells = 6;                        // that one brace may cross
    double pitch = 2.5;                   // mm, between parallel candidates
};

// The modes of one variant, lowest first.
struct VariantModes {
    std::size_t variant = 0;
    std::vector<BucklingMode> modes;
};

Layout braces(const TestRig& rig, const LoadCase& load_case, const std::vector<VariantModes>& modes,
              const BraceOptions& options);

}  // namespace bead
