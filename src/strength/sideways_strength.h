// The load at which a printed part buckles out of its plane. Beads are plates of the part's
// thickness (fem/sideways.h) but for how they twist: a bead is a strip as narrow as it is, and a
// strip that is higher than wide twists far more easily than a plate. So the twisting share of a
// pixel's stiffness, in its bead's axes, is that of a rectangle as wide as the solid is there
// across the bead (Saint-Venant's torsion; Roark's formula). Where beads cross it counts whole.
#pragma once
#include <optional>
#include <span>

#include "strength/test_rig.h"

namespace bead {

struct SidewaysOptions {
    double pixel = 0;  // mm; 0: a third of the bead's width
};

// N, the lowest of the variants; infinity where nothing is pressed; nothing if the print does not
// hang together or nothing holds it sideways. Layers that differ: beads run as in the first.
std::optional<double> sideways_load(std::span<const Toolpath> layers, const LoadCase& load_case,
                                    const SidewaysOptions& options = {});

// Whether it is worth a look: parts thinner than ten beads are wide that nothing guides.
bool is_thin(const LoadCase& load_case);

// Whether it counts as what the part bears: where the case says that nothing guides it, or says
// nothing and the part is thinner than five beads are wide.
bool counts_sideways(const LoadCase& load_case);

// Torsion of a strip `width` wide and `thickness` high, over what a plate's width would have.
double twist_share(double width, double thickness);

}  // namespace bead
