// One printer: its room, its nozzle, what its firmware allows, what it draws, how it
// shakes.
#pragma once
#include <array>
#include <string>

#include "geom/vec.h"
#include "machine/kinematics.h"
#include "machine/limits.h"
#include "machine/power.h"
#include "machine/vibration.h"

namespace bead {

struct Printer {
    std::string name;
    Kinematics kinematics = Kinematics::cartesian;
    Delta delta;                               // of a delta only
    std::array<double, 3> bed{250, 210, 210};  // mm: width, depth, height
    double nozzle = 0.4;                       // mm
    double filament = 1.75;                    // mm, diameter
    Limits limits;
    PowerModel power;
    VibrationModel vibration;
};

// mm, in the printer's own coordinates.
constexpr Vec2 middle_of_bed(const Printer& printer) {
    if (printer.kinematics == Kinematics::delta) return {};
    return {printer.bed[0] / 2, printer.bed[1] / 2};
}

}  // namespace bead
