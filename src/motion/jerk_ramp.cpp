#include "motion/jerk_ramp.h"

#include <algorithm>
#include <cmath>

namespace bead {

double ramp_time(double v0, double v1, const JerkLimits& limits) {
    const double d = std::abs(v1 - v0), a = limits.acceleration, j = limits.jerk;
    return d * j >= a * a ? d / a + a / j : 2 * std::sqrt(d / j);
}

double ramp_distance(double v0, double v1, const JerkLimits& limits) {
    return (v0 + v1) / 2 * ramp_time(v0, v1, limits);
}

double reach(double v, double distance, const JerkLimits& limits) {
    const double a = limits.acceleration, j = limits.jerk;
    const double bend = a * a / j;  // change of speed from which on the acceleration is reached
    if (ramp_distance(v, v + bend, limits) <= distance) {
        // d²/2a + d·(v/a + a/2j) + v·a/j = distance
        const double p = v + bend / 2;
        const double room = 2 * a * distance - 2 * v * bend;
        return v + std::sqrt(p * p + room) - p;
    }
    // With s = √(d/j):  j·s³ + 2·v·s = distance, a rising and hollow curve: Newton from above.
    double s = std::cbrt(distance / j);
    if (v > 0) s = std::min(s, distance / (2 * v));
    for (int i = 0; i < 50; ++i) {
        const double step = (s * (j * s * s + 2 * v) - distance) / (3 * j * s * s + 2 * v);
        s -= step;
        if (std::abs(step) <= 1e-15 * s) break;
    }
    return v + j * s * s;
}

double peak_speed(double v0, double v1, double distance, double cap, const JerkLimits& limits) {
    const double least = std::max(v0, v1);
    const auto needed = [&](double v) {
        return ramp_distance(v0, v, limits) + ramp_distance(v, v1, limits);
    };
    if (cap <= least || needed(least) >= distance) return least;
    if (needed(cap) <= distance) return cap;
    double low = least, high = std::min(cap, reach(std::min(v0, v1), distance, limits));
    for (int i = 0; i < 60 && high - low > 1e-12 * high; ++i) {
        const double middle = (low + high) / 2;
        (needed(middle) <= distance ? low : high) = middle;
    }
    return low;
}

}  // namespace bead
