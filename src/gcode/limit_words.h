// The words that set a machine's limits, as each dialect means them. Numbers that firmware refuses
// are passed over; where nothing is left there is no answer.
#pragma once
#include <optional>
#include <string_view>

#include "gcode/dialect.h"
#include "gcode/scanner.h"
#include "toolpath/command.h"

namespace bead {

using AxisLimits = PerAxis<std::optional<double>>;

// X, Y, Z and E of M201, M203: above 0; of M205, M566: not below it. `per`: what the text says for
// each mm/s (or mm/s²).
std::optional<AxisLimits> axis_limits(const Words& words, bool zero_allowed, double per);

// M205: jerk and, in Marlin, junction deviation (J).
std::optional<SetLimits> corner_limits(const Words& words, Dialect dialect);

// M204 in mm/s². S is the older word for printing and travel together.
std::optional<SetLimits> accelerations(const Words& words, Dialect dialect);

// SET_VELOCITY_LIMIT. The older ACCEL_TO_DECEL is told as a share of the acceleration, this
// command's or the one that stands.
std::optional<SetLimits> velocity_limits(std::string_view words,
                                         std::optional<double> acceleration);

}  // namespace bead
