// A load case and its designs larger or smaller: similar parts under the same forces. Strength and
// buckling loads grow with the square of the scale, weight with its cube.
//
//     const double scale = usual_scale(load_case.print);
//     const auto found = similar(*reinforced(similar(load_case, scale), options), 1 / scale);
#pragma once
#include "study/reinforce.h"

namespace bead {

LoadCase similar(LoadCase load_case, double scale);
Layout similar(Layout layout, double scale);
Strength similar(Strength strength, double scale);
Reinforced similar(Reinforced found, double scale);

}  // namespace bead
