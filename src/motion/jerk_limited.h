// The fastest sensible way along a path whose points and pieces have limits of speed, with limited
// acceleration and limited jerk: no speed limit is exceeded anywhere, acceleration never jumps, and
// the cost is linear in the number of points. Not the optimum: acceleration returns to zero at
// every slow place.
//
// Slow places are the anchors: the ends and every point that a plan with acceleration alone passes
// at its own limit, in a local minimum of speed. Between two anchors speed rises by one ramp, holds
// and falls by one (jerk_ramp.h); where that exceeds a point's limit, the lowest such point becomes
// an anchor too, until none does. Anchors too close to each other for the change of speed between
// them are lowered.
#pragma once
#include <vector>

namespace bead {

struct SpeedLimits {                   // of n pieces between n + 1 points
    std::vector<double> length;        // n, mm, above 0
    std::vector<double> speed;         // n, mm/s, most along the piece, above 0
    std::vector<double> acceleration;  // n, mm/s², above 0
    std::vector<double> point;         // n + 1, mm/s, most at the point; the speeds at both ends
    double jerk = 0;                   // mm/s³, above 0
};

// From time t (s) and place s (mm) on: speed, acceleration and jerk (mm, s).
struct JerkPhase {
    double t = 0, s = 0, v = 0, a = 0, j = 0;
};

struct SpeedPlan {
    std::vector<JerkPhase> phases;  // in order; the last one, at the end of the path, lasts no time
    std::vector<double> speed;      // n + 1, mm/s, at every point
    std::vector<double> time;       // n + 1, s, at which it is passed
    std::vector<bool> steady;       // n + 1, whether acceleration is 0 there
};

// The plan begins with the first point's speed, or the highest below it from which the rest can be
// met, and ends likewise.
SpeedPlan jerk_limited(const SpeedLimits& limits);

}  // namespace bead
