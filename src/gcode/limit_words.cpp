#include "gcode/limit_words.h"

#include <algorithm>

#include "gcode/key_words.h"

namespace bead {
namespace {

constexpr std::string_view limit_letters = "XYZE";

std::optional<double> above_zero(const Words& words, char letter) {
    if (!words.has(letter) || words.at(letter) <= 0) return {};
    return words.at(letter);
}

std::optional<double> above_zero(std::string_view words, std::string_view key) {
    const auto value = number_of(words, key).value;
    return value && *value > 0 ? value : std::nullopt;
}
std::optional<double> zero_or_more(std::string_view words, std::string_view key) {
    const auto value = number_of(words, key).value;
    return value && *value >= 0 ? value : std::nullopt;
}

std::optional<double> cruise_ratio(std::string_view words, std::optional<double> acceleration) {
    const auto ratio = zero_or_more(words, "MINIMUM_CRUISE_RATIO");
    if (ratio) return *ratio < 1 ? ratio : std::nullopt;
    const auto braking = above_zero(words, "ACCEL_TO_DECEL");
    if (!braking || !acceleration) return {};
    return 1 - std::min(1.0, *braking / *acceleration);
}

// S for printing and travel, with it T for retracting; in Prusa's of 2023 P, R, T where there is no
// S.
SetLimits prusa_accelerations(const Words& words, bool knows_prt) {
    SetLimits set;
    if (words.has('S') || !knows_prt) {
        set.acceleration = set.travel_acceleration = above_zero(words, 'S');
        set.retract_acceleration = above_zero(words, 'T');
    } else {
        set.acceleration = above_zero(words, 'P');
        set.retract_acceleration = above_zero(words, 'R');
        set.travel_acceleration = above_zero(words, 'T');
    }
    return set;
}

SetLimits marlin_accelerations(const Words& words) {
    const auto first = [&](char letter, char other) {
        return words.has(letter) ? above_zero(words, letter) : above_zero(words, other);
    };
    SetLimits set;
    set.acceleration = first('P', 'S');
    set.retract_acceleration = above_zero(words, 'R');
    set.travel_acceleration = first('T', 'S');
    return set;
}

// S, or the lower of P and T.
SetLimits klipper_acceleration(const Words& words) {
    SetLimits set;
    const auto p = above_zero(words, 'P'), t = above_zero(words, 'T');
    if (words.has('S'))
        set.max_acceleration_head = above_zero(words, 'S');
    else if (p && t)
        set.max_acceleration_head = std::min(*p, *t);
    return set;
}

}  // namespace

std::optional<AxisLimits> axis_limits(const Words& words, bool zero_allowed, double per) {
    AxisLimits limits;
    for (std::size_t axis = 0; axis < limits.size(); ++axis) {
        const char letter = limit_letters[axis];
        if (!words.has(letter)) continue;
        const double told = words.at(letter);
        if (told > 0 || (told == 0 && zero_allowed)) limits[axis] = told / per;
    }
    return limits == AxisLimits{} ? std::nullopt : std::optional(limits);
}

std::optional<SetLimits> corner_limits(const Words& words, Dialect dialect) {
    SetLimits set;
    const auto jerk = axis_limits(words, true, 1);
    if (jerk) set.jerk = *jerk;
    if (dialect == marlin_dialect) set.junction_deviation = above_zero(words, 'J');
    return jerk || set.junction_deviation ? std::optional(set) : std::nullopt;
}

std::optional<SetLimits> accelerations(const Words& words, Dialect dialect) {
    const bool of_2017 = dialect == prusa_2017_dialect;
    const SetLimits set = dialect == klipper_dialect ? klipper_acceleration(words)
                          : of_2017 || dialect == prusa_dialect
                              ? prusa_accelerations(words, !of_2017)
                              : marlin_accelerations(words);
    const bool any = set.acceleration || set.retract_acceleration || set.travel_acceleration ||
                     set.max_acceleration_head;
    return any ? std::optional(set) : std::nullopt;
}

std::optional<SetLimits> velocity_limits(std::string_view words,
                                         std::optional<double> acceleration) {
    SetLimits set;
    set.max_velocity = above_zero(words, "VELOCITY");
    set.max_acceleration_head = above_zero(words, "ACCEL");
    set.square_corner_velocity = zero_or_more(words, "SQUARE_CORNER_VELOCITY");
    if (set.max_acceleration_head) acceleration = set.max_acceleration_head;
    set.minimum_cruise_ratio = cruise_ratio(words, acceleration);
    const bool any = set.max_velocity || set.max_acceleration_head || set.square_corner_velocity ||
                     set.minimum_cruise_ratio;
    return any ? std::optional(set) : std::nullopt;
}

}  // namespace bead
