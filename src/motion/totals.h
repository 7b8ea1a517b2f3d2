// What a print comes to: time, ways, moves, by axis, by role and by layer. Fed block by block; a
// block costs a few additions, memory grows only with the number of layers.
#pragma once
#include <vector>

#include "motion/axis_times.h"

namespace bead {

struct RoleMotion {
    std::int64_t moves = 0;
    double duration = 0;  // s
    double length = 0;    // mm, of the head's way
    double extruded = 0;  // mm of filament laid down while the head moves
};
RoleMotion operator+(const RoleMotion& a, const RoleMotion& b);

// From one LayerStart to the next.
struct LayerMotion {
    double z = 0, height = 0;  // mm, as the file says; 0 before the first layer
    double dwell = 0;          // s
    PerRole<RoleMotion> by_role{};
};
RoleMotion total(const PerRole<RoleMotion>& by_role);
double duration(const LayerMotion& layer);  // s, dwells included

struct MotionTotals {
    double duration = 0;     // s, dwells included
    double dwell = 0;        // s
    std::int64_t moves = 0;  // blocks
    std::int64_t travel_moves = 0, retractions = 0;
    double length = 0;                // mm, of the head's way
    double travel = 0;                // mm of it without extrusion
    double extruded = 0;              // mm of filament laid down while the head moves
    double filament = 0;              // mm of filament drawn in, net of retractions
    double fastest = 0;               // mm/s along the path
    std::int64_t short_of_speed = 0;  // moves that never reach their nominal speed
    PerAxis<AxisTimes> axes{};
    PerAxis<double> fastest_axis{};  // mm/s
    PerRole<double> by_role{};       // s
    LayerMotion before_layers;
    std::vector<LayerMotion> by_layer{};
};

void add(MotionTotals& totals, const MotionEvent& event);

// Of all layers and what comes before them.
PerRole<RoleMotion> motion_by_role(const MotionTotals& totals);

}  // namespace bead
