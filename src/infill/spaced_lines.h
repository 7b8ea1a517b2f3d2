// Lines along a principal direction at a distance that may differ from place to place (Jobard and
// Lefer 1997): beside every line that is found seeds are tried at the distance to both sides, and a
// line ends where it comes nearer to another of its family than a part of the distance.
#pragma once
#include <functional>

#include "infill/principal_lines.h"

namespace bead {

struct SpacedOptions {
    std::function<double(Vec2)> spacing;  // mm
    double largest = 12;                  // mm, no spacing is larger
    double end_at = 0.5;                  // of the spacing, at which a line ends
    double shortest = 3;                  // mm, lines that are kept
    TraceOptions trace{};
};

// `seeds`: tried first, in their order, then again for what is still bare after all others.
std::vector<Polyline> spaced_lines(const TensorField& field, const Region& region,
                                   PrincipalFamily family, const std::vector<Vec2>& seeds,
                                   const SpacedOptions& options);

}  // namespace bead
