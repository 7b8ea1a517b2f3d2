#include "job/limit_trail.h"

namespace bead {
namespace {

using Values = PerAxis<std::optional<double>>;

bool any(const Values& values) { return values != Values{}; }

bool differs(const NamedLimit& limit, const Limits& before, const Limits& after) {
    for (std::size_t axis = 0; axis < limit.count; ++axis)
        if (limit.get(before, axis) != limit.get(after, axis)) return true;
    return false;
}

}  // namespace

std::string_view command_of(const SetLimits& told) {
    if (any(told.max_acceleration)) return "M201";
    if (any(told.max_feedrate)) return "M203";
    if (told.acceleration || told.retract_acceleration || told.travel_acceleration) return "M204";
    if (any(told.jerk) || told.junction_deviation) return "M205";
    const bool more = told.max_velocity || told.square_corner_velocity || told.minimum_cruise_ratio;
    return told.max_acceleration_head && !more ? "M204 or SET_VELOCITY_LIMIT"
                                               : "SET_VELOCITY_LIMIT";
}

LimitTrail::LimitTrail() : changes_(named_limits().size()) {}

void LimitTrail::note(const SetLimits& told, std::int64_t line, const Limits& before,
                      const Limits& after) {
    for (std::size_t i = 0; i < changes_.size(); ++i) {
        if (!differs(named_limits()[i], before, after)) continue;
        LimitChange& change = changes_[i];
        if (change.times++ > 0) continue;
        change.first_line = line;
        change.command = command_of(told);
    }
}

std::optional<LimitChange> LimitTrail::change(const NamedLimit& limit) const {
    const LimitChange& found = changes_[std::size_t(&limit - named_limits().data())];
    if (found.times == 0) return std::nullopt;
    return found;
}

}  // namespace bead
