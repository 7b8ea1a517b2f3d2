// The first failure of beads that are stiffer and stronger along than across, as printed ones are:
// Hashin's criterion (1980) in each bead's own axes. Where beads cross, the plastic is taken as
// alike in all directions and somewhat weaker than along a bead.
#pragma once
#include <span>

#include "strength/test_rig.h"

namespace bead {

struct BeadAnisotropy {
    double across_stiffness = 0.7;  // of along
    double across_strength = 0.6;   // of the tensile strength
    double shear_strength = 0.5;    // of the tensile strength
    double crossing = 0.8;          // strength where beads cross
};

// N, the worst of the variants.
double anisotropic_failure_load(std::span<const Toolpath> layers, const LoadCase& load_case,
                                const TestRig& isotropic_rig, const BeadAnisotropy& beads = {});

// 1: fails. `stress` in the bead's axes, x along it.
double hashin_index(PlaneTensor stress, const SolidMaterial& material, const BeadAnisotropy& beads);

}  // namespace bead
