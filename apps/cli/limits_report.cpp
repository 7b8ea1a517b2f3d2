#include "limits_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace bead::cli {
namespace {

constexpr std::array<std::string_view, 7> usual_names{
    "steps_per_mm",       "max_feedrate_mm_s",          "max_acceleration_mm_s2",
    "acceleration_mm_s2", "retract_acceleration_mm_s2", "travel_acceleration_mm_s2",
    "jerk_mm_s"};

Json one_value(const NamedLimit& limit, double value) {
    if (limit.form == LimitForm::flag) return value != 0;
    if (limit.form == LimitForm::whole) return static_cast<std::int64_t>(value);
    return value;
}

Json value_json(const NamedLimit& limit, const Limits& limits) {
    if (limit.count == 1) return one_value(limit, limit.get(limits, 0));
    Json values = Json::array();
    for (std::size_t axis = 0; axis < limit.count; ++axis)
        values.push_back(one_value(limit, limit.get(limits, axis)));
    return values;
}

std::string first_of(const LimitChange& change) {
    return fmt::format("{}, line {}", change.command, change.first_line);
}

std::string short_number(double value) { return fmt::format("{:.6g}", value); }

// "X 500, Z 12" or "800"
std::string last_values(const NamedLimit& limit, const Limits& first, const Limits& last) {
    constexpr std::array names{"X", "Y", "Z", "E"};
    if (limit.count == 1) return short_number(limit.get(last, 0));
    std::string text;
    for (std::size_t axis = 0; axis < limit.count; ++axis)
        if (limit.get(first, axis) != limit.get(last, axis))
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", names[axis],
                                short_number(limit.get(last, axis)));
    return text.empty() ? "as before" : text;
}

std::string where_from(const JudgedFile& judged, const NamedLimit& limit) {
    std::string text = judged.choice.limits.source(limit);
    if (const auto change = judged.trail.change(limit))
        text += fmt::format("; then {}, {} time{}, last {}", first_of(*change), change->times,
                            change->times == 1 ? "" : "s",
                            last_values(limit, judged.choice.limits.limits(), judged.last));
    return text;
}

void print_row(const Console& console, const JudgedFile& judged, const NamedLimit& limit) {
    const Limits& limits = judged.choice.limits.limits();
    std::array<std::string, 4> cells;
    for (std::size_t axis = 0; axis < limit.count; ++axis)
        cells[axis] = limit.form == LimitForm::flag ? limit.get(limits, axis) != 0 ? "yes" : "no"
                                                    : short_number(limit.get(limits, axis));
    // The square of mm/s² is two bytes wide.
    const std::size_t unit_width = limit.unit.ends_with("²") ? 7 : 6;
    console.say("{:>20} {:<{}} {:>8} {:>8} {:>8} {:>8}  {}\n", limit.about, limit.unit, unit_width,
                cells[0], cells[1], cells[2], cells[3], where_from(judged, limit));
}

}  // namespace

Json limits_json(const JudgedFile& judged) {
    Json all = Json::object();
    for (const NamedLimit& limit : named_limits()) {
        const bool usual = std::ranges::find(usual_names, limit.name) != usual_names.end();
        if (!usual && !uses(judged.choice.firmware.firmware, limit)) continue;
        Json row{{"value", value_json(limit, judged.choice.limits.limits())},
                 {"source", judged.choice.limits.source(limit)}};
        if (const auto change = judged.trail.change(limit))
            row["changed"] = {{"times", change->times},
                              {"first_line", change->first_line},
                              {"first", first_of(*change)},
                              {"last", value_json(limit, judged.last)}};
        all[std::string(limit.name)] = std::move(row);
    }
    return all;
}

void print_limits(const Console& console, const JudgedFile& judged) {
    console.say("\n{:>20} {:<6} {:>8} {:>8} {:>8} {:>8}  {}\n", "limit", "", "X", "Y", "Z", "E",
                "from");
    for (const NamedLimit& limit : named_limits())
        if (uses(judged.choice.firmware.firmware, limit)) print_row(console, judged, limit);
}

}  // namespace bead::cli
