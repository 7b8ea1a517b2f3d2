// The test of a printed structure, by calculation: stiffness, the load at which it first fails, and
// those at which it buckles in its plane and, if it is thin, out of it, all for the plastic that
// was deposited. Judged is what is printed (beads on pixels of a sixth of their width), whoever
// planned it; docs/stress-lines.md says why each number is defined as it is.
//
//     const Strength strength = strength_of(layers, load_case, {});
#pragma once
#include <optional>
#include <span>

#include "strength/test_rig.h"

namespace bead {

struct StrengthOptions {
    double pixel = 0;  // mm; 0: a sixth of the bead's width
    bool buckling = true;
    bool sideways = true;      // out of the plane too if the part is thin; else if it counts
    bool progressive = false;  // what it bears after the first failures
    bool anisotropic = false;  // beads stronger along than across
};

// Where there are several situations, or loads with ranges, the worst of them counts.
struct Strength {
    bool holds = false;          // the loads find a way to the supports; else all below is 0
    double volume = 0;           // mm³, deposited, overlaps counted twice, the whole height
    double mass = 0;             // g
    double covered = 0;          // mm², seen from above
    double stiffness = 0;        // N/mm, force² / work
    double failure_load = 0;     // N, first failure
    Vec2 weakest;                // where
    double buckling_load = 0;    // N
    double buckling_factor = 0;  // of the case's loads
    std::optional<double> sideways_load;     // N, at which a thin part buckles out of its plane
    bool counts_sideways = false;            // whether that is what it bears
    std::optional<double> peak_load;         // N, progressive
    std::optional<double> anisotropic_load;  // N
    // N, at which it is no longer what it was.
    [[nodiscard]] double bears() const {
        const double load = counts_sideways
                                ? std::min(failure_load, sideways_load.value_or(failure_load))
                                : failure_load;
        return buckling_load > 0 ? std::min(load, buckling_load) : load;
    }
};

// `layers`: those of one part, or one that stands for all of them; each counts by its height, all
// together as the case's thickness.
Strength strength_of(std::span<const Toolpath> layers, const LoadCase& load_case,
                     const StrengthOptions& options);

// Layers that the case's thickness takes.
int layer_count(const LoadCase& load_case);

}  // namespace bead
