// How long a firmware's planner takes for the paths of one layer, from rest to rest, retraction and
// lift as the file has them.
#pragma once
#include "gcode/motion_style.h"
#include "motion/planner.h"
#include "toolpath/path.h"

namespace bead::cli {

struct FirmwareClock {
    Limits limits;
    PlannerOptions motion;
};

// s
double firmware_time(const Toolpath& layer, const FirmwareClock& clock, const MotionStyle& style);

// mm of travel at that speed that pulling filament back takes as long as, once.
double retraction_way(double speed, const FirmwareClock& clock, const MotionStyle& style);

}  // namespace bead::cli
