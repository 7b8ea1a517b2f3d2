// The lengths that tests and designs go by (the failure index averaged over 0.6 mm, 4 mm around
// loads that are not judged, a brace of 2.5 mm …) are those of ordinary nozzles. Beads much wider
// or finer are judged as the similar part of ordinary beads: times this scale.
#pragma once
#include "fem/load_case.h"

namespace bead {

// 1 for beads of 0.4 to 0.9 mm; else what makes them so.
double usual_scale(const PrintWish& print);

}  // namespace bead
