// Motion as the machine is asked for it: straight pieces of constant jerk, one after the other.
#pragma once
#include <functional>

#include "geom/vec.h"

namespace bead {

struct MotionSegment {
    double duration = 0;  // s
    Vec2 from{};          // mm
    Vec2 direction{};     // unit vector; (0, 0) while the head stands still
    double length = 0;    // mm
    double speed = 0, acceleration = 0, jerk = 0;  // mm/s, mm/s², mm/s³, at its start
    double nominal = 0;                            // mm/s, speed asked for
    double flow = 0;                               // mm³ of melt per mm of way; 0: travel
};

using SegmentSink = std::function<void(const MotionSegment&)>;

// After t s.
constexpr double way(const MotionSegment& s, double t) {
    return t * (s.speed + t * (s.acceleration / 2 + t * s.jerk / 6));
}
constexpr double speed(const MotionSegment& s, double t) {
    return s.speed + t * (s.acceleration + t * s.jerk / 2);
}
constexpr Vec2 end(const MotionSegment& s) { return s.from + s.length * s.direction; }

}  // namespace bead
