// What a printed body bears after its first failures: what fails is taken away and the load is
// raised again, until it falls apart. The highest load on the way is the peak.
#pragma once
#include "strength/test_rig.h"

namespace bead {

// Of the variant's loads; `first` is the whole body's test.
double peak_factor(const TestRig& rig, std::size_t variant, const Tested& first);

}  // namespace bead
