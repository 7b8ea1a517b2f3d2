// How a flat part is held against moving sideways, and when it buckles so. A case says what holds
// in the plane only; out of it a part is taken to be held as its supports hold it: where both
// directions are fixed along a stretch it is clamped, at other supports it cannot deflect but may
// turn. Loads follow the part; only where supports alone would let it fall over do loads keep it
// from deflecting too, as the jaws of a test rig do.
#pragma once
#include <optional>

#include "fem/load_case.h"
#include "fem/plate_buckling.h"

namespace bead {

// Factor of the loads; nothing if nothing holds the part sideways, 0 if nothing presses it.
// `displacement`: in the plane, of these supports and loads. `reach`: mm, as in pixel_boundary.h.
std::optional<PlateBuckling> sideways_buckling(
    const PixelModel& sheet, std::span<const PlaneLaw> rigidity, const LoadCase& load_case,
    const Situation& situation, std::span<const double> displacement, double reach = 0);

// The lowest factors of the solid part, in its plane and out of it; 0 where nothing is pressed.
struct SolidBuckling {
    double in_plane = 0;
    std::optional<double> sideways;  // nothing: not held sideways
    double pixel = 0;                // mm
};
// `pixel` in mm; 0: the root of the part's area over 100.
SolidBuckling solid_buckling(const LoadCase& load_case, std::size_t situation, double pixel = 0);

}  // namespace bead
