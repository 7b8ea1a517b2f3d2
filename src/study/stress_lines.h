// Densities made into beads: a stripe pattern per family, cut to the part, free ends trimmed, and
// the spacing tuned until they weigh what they may.
#pragma once
#include <cstdint>

#include "study/densities.h"

namespace bead {

struct StressLineOptions {
    double area = 0;           // mm², all beads, walls and pads included
    double tolerance = 0.006;  // of the area
    int trials = 7;
    double least = 0.5, most = 8;  // mm, spacing
    std::uint32_t seed = 0;
    double grid = 0.5;  // mm, of the stripes' vertices
};

// The fixed lines and both families. The nearest that was found where the tolerance was not met.
Layout stress_lines(const LoadCase& load_case, const Layout& fixed, const Densities& densities,
                    const StressLineOptions& options);

}  // namespace bead
