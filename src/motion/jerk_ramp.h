// One change of speed with limited acceleration and jerk, at rest in acceleration at both ends:
// acceleration rises, holds, falls. Closed forms; d = |v1 - v0|, A the acceleration, J the jerk:
//     time      d/A + A/J if d >= A²/J, else 2·√(d/J)
//     distance  (v0 + v1)/2 · time
#pragma once

namespace bead {

struct JerkLimits {
    double acceleration = 0;  // mm/s²
    double jerk = 0;          // mm/s³
};

double ramp_time(double v0, double v1, const JerkLimits& limits);      // s
double ramp_distance(double v0, double v1, const JerkLimits& limits);  // mm

// The highest speed that can be reached from v within the distance (mm).
double reach(double v, double distance, const JerkLimits& limits);

// The highest speed in between, no more than cap, from which v1 can still be met at the end of the
// distance after v0 at its start; at least the larger of the two.
double peak_speed(double v0, double v1, double distance, double cap, const JerkLimits& limits);

}  // namespace bead
