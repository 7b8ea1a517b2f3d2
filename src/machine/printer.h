// One printer: its room, its nozzle, what its firmware allows and what it draws.
#pragma once
#include <array>
#include <string>

#include "machine/limits.h"
#include "machine/power.h"

namespace bead {

enum class Kinematics { cartesian, corexy, corexz, delta };

struct Printer {
    std::string name;
    Kinematics kinematics = Kinematics::cartesian;
    std::array<double, 3> bed{250, 210, 210};  // mm: width, depth, height
    double nozzle = 0.4;                       // mm
    double filament = 1.75;                    // mm, diameter
    Limits limits;
    PowerModel power;
};

}  // namespace bead
