// How fast a corner may be passed, by Klipper's "approximated centripetal velocity" (toolhead.py):
// the speed at which a circle that touches both legs and passes the corner at a distance needs no
// more than their acceleration. The circle touches the legs no further away than at their middles.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "toolpath/command.h"

namespace bead {

struct Leg {
    PerAxis<double> direction{};  // way of each axis per mm of the path; only X, Y, Z count
    double length = 0;            // mm
    double acceleration = 0;      // mm/s²
    double deviation = 0;         // mm, distance of corner and circle
};

// The distance at which a right-angled corner is passed at the square corner velocity (mm/s).
inline double corner_deviation(double square_corner_velocity, double acceleration) {
    return square_corner_velocity * square_corner_velocity * (std::numbers::sqrt2 - 1) /
           acceleration;
}

// Speed squared, (mm/s)²; 0 where the path turns back.
inline double corner_speed2(const Leg& before, const Leg& after) {
    constexpr double straight = 0.999999;
    double cosine = 0;  // of the angle between the legs: -1 is straight on
    for (const Axis i : {axis_x, axis_y, axis_z})
        cosine -= after.direction[i] * before.direction[i];
    if (cosine > straight) return 0;
    cosine = std::max(cosine, -straight);
    const double half_sine = std::sqrt(0.5 * (1 - cosine));
    const double radius = half_sine / (1 - half_sine);  // per mm of deviation
    const double half_tangent = half_sine / std::sqrt(0.5 * (1 + cosine));
    const auto within = [&](const Leg& leg) {
        return leg.acceleration * std::min(radius * leg.deviation, 0.5 * leg.length * half_tangent);
    };
    return std::min(within(before), within(after));
}

// The same for the filament: its speed may step by `most` (mm/s) where its share of the path
// changes.
inline double filament_corner_speed2(const Leg& before, const Leg& after, double most) {
    const double change = after.direction[axis_e] - before.direction[axis_e];
    if (change == 0) return std::numeric_limits<double>::infinity();
    return most / change * (most / change);
}

}  // namespace bead
