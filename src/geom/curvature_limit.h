// How tightly a path may bend at a speed, and how fast it may be run where it bends more.
//
// Four things bound the curvature κ at speed v: the chord error δ of an interpolator of period T,
// 8δ / ((vT)² + 4δ²); normal acceleration, A / v²; the jerk of running round at constant speed,
// √(J / v³); and the nozzle's radius, below which the inside of a bead is printed twice. The feed
// limit turns the first three round: v = min((2/T) √(2δ/κ - δ²), √(A/κ), ∛(J/κ²)), and where
// curvature changes by κ' per mm, v³ κ' is jerk as well: v <= ∛(J/κ'). A corner or an arc that
// begins at once has no κ': blends whose curvature begins at 0 do.
#pragma once

namespace bead {

struct CurvatureLimits {
    double normal_acceleration = 1000;  // mm/s²
    double normal_jerk = 2e4;           // mm/s³
    double chord_error = 0.01;          // mm
    double period = 1e-3;               // s between interpolated points; 0: no chord error
    double nozzle_radius = 0.2;         // mm
};

// 1/mm, each for itself. `speed` above 0.
struct CurvatureBounds {
    double chord = 0, acceleration = 0, jerk = 0, nozzle = 0;
};
CurvatureBounds curvature_bounds(const CurvatureLimits& limits, double speed);

// The least of them, K_cr.
double largest_curvature(const CurvatureLimits& limits, double speed);

// mm/s at a curvature (1/mm) and its change along the path (1/mm²), both of any sign; infinity for
// a straight line.
double feed_limit(const CurvatureLimits& limits, double curvature, double curvature_change = 0);

}  // namespace bead
