#include "energy/published.h"

#include <algorithm>
#include <cmath>

namespace bead {

namespace {

// A move of less than this on an axis (mm) is none: positions are whole steps, the rest is
// rounding.
constexpr double standstill = 1e-9;

double square(double x) { return x * x; }

// What is left of kC for coasting once the standing power is charged apart, J per mm.
double moving_cost(const MotorCoefficients& k, double usual_speed) {
    return std::max(0.0, k.c - k.h / usual_speed);
}

}  // namespace

Features features_of(const Block& block) {
    const double seconds = duration(block);
    const double K = square(block.v_peak) - (square(block.v_entry) + square(block.v_exit)) / 2;
    const double per = block.length > 0 ? 1 / block.length : 0.0;
    const auto share = [&](Axis axis) { return std::abs(block.delta[axis]) * per; };
    const auto hold = [&](Axis axis) {
        return std::abs(block.delta[axis]) < standstill ? seconds : 0.0;
    };
    const double rx = share(axis_x), ry = share(axis_y);
    return {.A = square(rx) * K,
            .B = square(ry) * K,
            .C = (rx + ry) * block.v_peak * block.t_cruise,
            .H = hold(axis_x) + hold(axis_y),
            .axis_time = 2 * seconds};
}

double published_energy(const Features& features, const MotorCoefficients& k) {
    return k.a * features.A + k.b * features.B + k.c * features.C + k.h * features.H;
}

double standing_form(const Features& features, const MotorCoefficients& k, double usual_speed) {
    return k.a * features.A + k.b * features.B + moving_cost(k, usual_speed) * features.C +
           k.h * features.axis_time;
}

}  // namespace bead
