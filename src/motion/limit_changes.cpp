#include "motion/limit_changes.h"

namespace bead {
namespace {

void put(double& value, const std::optional<double>& change) {
    if (change && *change > 0) value = *change;
}

void put(PerAxis<double>& values, const PerAxis<std::optional<double>>& changes) {
    for (std::size_t i = 0; i < values.size(); ++i) put(values[i], changes[i]);
}

PerAxis<std::optional<double>> all(const PerAxis<double>& values) {
    return {values[0], values[1], values[2], values[3]};
}

}  // namespace

Limits changed(Limits limits, const SetLimits& change) {
    put(limits.max_acceleration, change.max_acceleration);
    put(limits.max_feedrate, change.max_feedrate);
    put(limits.jerk, change.jerk);
    put(limits.acceleration, change.acceleration);
    put(limits.retract_acceleration, change.retract_acceleration);
    put(limits.travel_acceleration, change.travel_acceleration);
    put(limits.junction_deviation, change.junction_deviation);
    put(limits.max_feedrate[axis_x], change.max_velocity);
    put(limits.max_feedrate[axis_y], change.max_velocity);
    put(limits.square_corner_velocity, change.square_corner_velocity);
    if (change.minimum_cruise_ratio && *change.minimum_cruise_ratio >= 0)
        limits.minimum_cruise_ratio = *change.minimum_cruise_ratio;
    return limits;
}

SetLimits as_command(const Limits& limits) {
    return {.max_acceleration = all(limits.max_acceleration),
            .max_feedrate = all(limits.max_feedrate),
            .jerk = all(limits.jerk),
            .acceleration = limits.acceleration,
            .retract_acceleration = limits.retract_acceleration,
            .travel_acceleration = limits.travel_acceleration};
}

}  // namespace bead
