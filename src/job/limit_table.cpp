#include "job/limit_table.h"

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/expects.h"

namespace bead {
namespace {

// What no machine exceeds, nor needs; between them no time, length or speed overflows.
constexpr Range sane{.low = 1e-6, .high = 1e9};
constexpr Range sane_or_zero{.low = 0, .high = 1e9};
constexpr Range fraction{.low = 0, .high = 1};

constexpr unsigned bit(Firmware firmware) { return 1U << static_cast<unsigned>(firmware); }
constexpr unsigned prusas = bit(Firmware::prusa) | bit(Firmware::prusa_2017);
constexpr unsigned marlins = bit(Firmware::marlin_jerk) | bit(Firmware::marlin_jd);
constexpr unsigned klipper = bit(Firmware::klipper), s_curve = bit(Firmware::s_curve);
constexpr unsigned all = prusas | marlins | klipper | s_curve;

template <auto member>
constexpr NamedLimit per_axis(std::string_view name, std::string_view about, std::string_view unit,
                              unsigned used_by) {
    return {name,
            about,
            unit,
            4,
            sane,
            LimitForm::number,
            used_by,
            [](const Limits& l, std::size_t axis) { return (l.*member)[axis]; },
            [](Limits& l, std::size_t axis, double value) { (l.*member)[axis] = value; }};
}

template <auto member>
constexpr NamedLimit single(std::string_view name, std::string_view about, std::string_view unit,
                            unsigned used_by, const Range& allowed = sane,
                            LimitForm form = LimitForm::number) {
    using Value = std::remove_reference_t<decltype(std::declval<Limits>().*member)>;
    return {name,
            about,
            unit,
            1,
            allowed,
            form,
            used_by,
            [](const Limits& l, std::size_t) { return static_cast<double>(l.*member); },
            [](Limits& l, std::size_t, double v) { l.*member = static_cast<Value>(v); }};
}

using L = Limits;
constexpr std::array rows{
    per_axis<&L::steps_per_mm>("steps_per_mm", "steps", "1/mm", prusas | marlins),
    per_axis<&L::max_feedrate>("max_feedrate_mm_s", "speed", "mm/s", all),
    per_axis<&L::max_acceleration>("max_acceleration_mm_s2", "acceleration", "mm/s²", all),
    single<&L::acceleration>("acceleration_mm_s2", "printing", "mm/s²", all),
    single<&L::retract_acceleration>("retract_acceleration_mm_s2", "retracting", "mm/s²",
                                     prusas | marlins | s_curve),
    single<&L::travel_acceleration>("travel_acceleration_mm_s2", "travelling", "mm/s²",
                                    bit(Firmware::prusa) | marlins | s_curve),
    per_axis<&L::jerk>("jerk_mm_s", "jerk", "mm/s", prusas | bit(Firmware::marlin_jerk)),
    single<&L::junction_deviation>("junction_deviation_mm", "junction deviation", "mm",
                                   bit(Firmware::marlin_jd)),
    single<&L::square_corner_velocity>("square_corner_velocity_mm_s", "square corner", "mm/s",
                                       klipper | s_curve, sane_or_zero),
    single<&L::minimum_cruise_ratio>("minimum_cruise_ratio", "minimum cruise ratio", "", klipper,
                                     fraction),
    single<&L::extrude_only_velocity>("extrude_only_velocity_mm_s", "filament alone", "mm/s",
                                      klipper),
    single<&L::extrude_only_acceleration>("extrude_only_acceleration_mm_s2", "filament alone",
                                          "mm/s²", klipper),
    single<&L::instantaneous_corner_velocity>("instantaneous_corner_velocity_mm_s",
                                              "filament's corner", "mm/s", klipper | s_curve),
    single<&L::path_jerk>("path_jerk_mm_s3", "jerk of the path", "mm/s³", s_curve),
    single<&L::arc_resolution>("arc_resolution_mm", "chords of arcs", "mm", all),
    single<&L::drop_segments>("drop_segments_steps", "moves joined up to", "steps",
                              prusas | marlins, {.low = 0, .high = 1000}, LimitForm::whole),
    single<&L::slowdown>("slowdown", "short moves stretched", "", prusas | marlins,
                         {.low = 0, .high = 1}, LimitForm::flag),
};

std::vector<double> told(TomlReader& file, const std::string& key, const NamedLimit& limit) {
    switch (limit.form) {
        case LimitForm::whole:
            return {double(file.integer(key, 0, limit.allowed))};
        case LimitForm::flag:
            return {file.flag(key, false) ? 1.0 : 0.0};
        case LimitForm::number:
            break;
    }
    if (limit.count == 1) return {file.number(key, 1, limit.allowed)};
    const auto values = file.numbers(key, std::array<double, 4>{1, 1, 1, 1}, limit.allowed);
    return {values.begin(), values.end()};
}

}  // namespace

std::span<const NamedLimit> named_limits() { return rows; }

const NamedLimit& named_limit(std::string_view name) {
    const auto row = std::ranges::find(rows, name, &NamedLimit::name);
    BEAD_EXPECTS(row != rows.end());
    return *row;
}

bool uses(Firmware firmware, const NamedLimit& limit) {
    return (limit.used_by & bit(firmware)) != 0;
}

bool is_allowed(const NamedLimit& limit, double value) {
    return value >= limit.allowed.low && value <= limit.allowed.high;  // so it is a number too
}

std::vector<StatedLimit> stated_limits(TomlReader& file) {
    std::vector<StatedLimit> stated;
    for (const NamedLimit& limit : rows) {
        const std::string key = "limits." + std::string(limit.name);
        const std::optional<std::string> place = file.place_of(key);
        const std::vector<double> values = told(file, key, limit);
        if (!place) continue;
        for (std::size_t axis = 0; axis < limit.count; ++axis)
            stated.push_back({limit.name, axis, values[axis], *place});
    }
    return stated;
}

SourcedLimits::SourcedLimits(const Limits& limits, const std::string& source)
    : limits_(limits), sources_(rows.size(), {source, source, source, source}) {}

void SourcedLimits::put(const StatedLimit& limit) {
    const NamedLimit& row = named_limit(limit.name);
    BEAD_EXPECTS(limit.axis < row.count && is_allowed(row, limit.value));
    row.put(limits_, limit.axis, limit.value);
    sources_[std::size_t(&row - rows.data())][limit.axis] = limit.source;
}

void SourcedLimits::put(const std::vector<StatedLimit>& limits) {
    for (const StatedLimit& limit : limits) put(limit);
}

std::string SourcedLimits::source(const NamedLimit& limit) const {
    constexpr std::array names{"X", "Y", "Z", "E"};
    const auto& sources = sources_[std::size_t(&limit - rows.data())];
    const std::span<const std::string> by_axis(sources.data(), limit.count);
    if (std::ranges::count(by_axis, by_axis[0]) == std::ptrdiff_t(limit.count)) return by_axis[0];
    std::string text;
    for (std::size_t i = 0; i < by_axis.size(); ++i) {
        if (std::ranges::find(by_axis.first(i), by_axis[i]) != by_axis.first(i).end()) continue;
        if (!text.empty()) text += "; ";
        for (std::size_t k = i; k < by_axis.size(); ++k)
            if (by_axis[k] == by_axis[i]) text += std::string(k > i ? ", " : "") + names[k];
        text += ": " + by_axis[i];
    }
    return text;
}

}  // namespace bead
