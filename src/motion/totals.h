// What a print comes to: time, ways, moves, by axis and by role. Fed block by block.
#pragma once
#include "motion/axis_times.h"

namespace bead {

struct MotionTotals {
    double duration = 0;     // s, dwells included
    double dwell = 0;        // s
    std::int64_t moves = 0;  // blocks
    std::int64_t travel_moves = 0, retractions = 0;
    double length = 0;                // mm, of the head's way
    double travel = 0;                // mm of it without extrusion
    double extruded = 0;              // mm of filament laid down while the head moves
    double filament = 0;              // mm of filament drawn in, net of retractions
    double fastest = 0;               // mm/s
    std::int64_t short_of_speed = 0;  // moves that never reach their nominal speed
    PerAxis<AxisTimes> axes{};
    PerRole<double> by_role{};  // s
};

void add(MotionTotals& totals, const MotionEvent& event);

}  // namespace bead
