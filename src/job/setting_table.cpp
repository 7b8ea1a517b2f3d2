#include "job/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "job/one_line.h"

namespace bead {
namespace {

struct Allowed {
    double low = 0, high = 0;
    [[nodiscard]] bool holds(double value) const { return value >= low && value <= high; }
};
constexpr Allowed printing_speed{0.1, 2000};  // mm/s
constexpr Allowed bead_width{0.05, 50};       // mm
constexpr Allowed layer_height{0.01, 10};     // mm
constexpr Allowed any_count{0, 1000};
constexpr Allowed whole_share{0, 1};
constexpr Allowed any_angle{-360, 360};  // °

std::string text_of(double value) { return fmt::format("{:.12g}", value); }

std::string text_of(const Allowed& range) {
    return fmt::format("{} … {}", text_of(range.low), text_of(range.high));
}

// The whole text as a number of the type, no part of it left over.
template <class T>
std::optional<T> number_as(std::string_view text) {
    T value{};
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc() || stop != end) return std::nullopt;
    return value;
}

// "0.2", "20%" and "20 %" are the same.
std::optional<double> share_in(std::string_view text) {
    if (!text.ends_with('%')) return number_as<double>(text);
    text = trimmed(text.substr(0, text.size() - 1));
    const std::optional<double> percent = number_as<double>(text);
    return percent ? std::optional(*percent / 100) : std::nullopt;
}

// The rows' makers. `place` maps Settings to the double, int or bool that is meant.

template <class Place>
Setting number(std::string_view name, std::string_view about, Allowed range, Place place,
               double unit = 1) {
    const auto set = [range, place, unit](Settings& settings, std::string_view text) {
        const std::optional<double> value = number_as<double>(text);
        if (!value || !range.holds(*value)) return false;
        place(settings) = *value * unit;
        return true;
    };
    const auto get = [place, unit](const Settings& settings) {
        return text_of(place(settings) / unit);
    };
    return {name, about, "a number in " + text_of(range), set, get};
}

template <class Place>
Setting angle(std::string_view name, std::string_view about, Place place) {
    return number(name, about, any_angle, place, pi / 180);
}

template <class Place>
Setting speed(std::string_view name, std::string_view about, Place place) {
    return number(name, about, printing_speed, place);
}

template <class Place>
Setting share(std::string_view name, std::string_view about, Place place) {
    const auto set = [place](Settings& settings, std::string_view text) {
        const std::optional<double> value = share_in(text);
        if (!value || !whole_share.holds(*value)) return false;
        place(settings) = *value;
        return true;
    };
    const auto get = [place](const Settings& settings) { return text_of(place(settings)); };
    return {name, about, "a number in 0 … 1 (0 % … 100 %)", set, get};
}

template <class Place>
Setting count(std::string_view name, std::string_view about, Place place) {
    const auto set = [place](Settings& settings, std::string_view text) {
        const std::optional<int> value = number_as<int>(text);
        if (!value || !any_count.holds(*value)) return false;
        place(settings) = *value;
        return true;
    };
    const auto get = [place](const Settings& settings) { return std::to_string(place(settings)); };
    return {name, about, "a whole number in " + text_of(any_count), set, get};
}

template <class Place>
Setting truth(std::string_view name, std::string_view about, Place place) {
    const auto set = [place](Settings& settings, std::string_view text) {
        const bool yes = text == "true" || text == "1";
        if (!yes && text != "false" && text != "0") return false;
        place(settings) = yes;
        return true;
    };
    const auto get = [place](const Settings& settings) {
        return std::string(place(settings) ? "true" : "false");
    };
    return {name, about, "true or false", set, get};
}

Setting pattern(std::string_view name, std::string_view about) {
    std::string allowed = "one of ";
    for (const NamedPattern& row : patterns)
        allowed += fmt::format("{}{}", row.name == patterns[0].name ? "" : ", ", row.name);
    const auto set = [](Settings& settings, std::string_view text) {
        const auto* const row = std::ranges::find(patterns, text, &NamedPattern::name);
        if (row == patterns.end()) return false;
        settings.plan.pattern = *row;
        return true;
    };
    const auto get = [](const Settings& settings) {
        return std::string(settings.plan.pattern.name);
    };
    return {name, about, allowed, set, get};
}

std::vector<Setting> table() {
    return {
        number(
            "layer_height_mm", "height of a layer", layer_height,
            [](auto& s) -> auto& { return s.slice.layer_height; }),
        number(
            "first_layer_height_mm", "height of the first layer", layer_height,
            [](auto& s) -> auto& { return s.slice.first_layer_height; }),
        number(
            "bead_width_mm", "width of a deposited line", bead_width,
            [](auto& s) -> auto& { return s.plan.bead_width; }),
        number(
            "first_layer_width_mm", "width of a deposited line of the first layer", bead_width,
            [](auto& s) -> auto& { return s.plan.first_layer_width; }),
        count(
            "walls", "loops along each outline", [](auto& s) -> auto& { return s.plan.walls; }),
        count(
            "top_layers", "solid layers below what is open to the top",
            [](auto& s) -> auto& { return s.plan.top_layers; }),
        count(
            "bottom_layers", "solid layers above what is open to the bottom",
            [](auto& s) -> auto& { return s.plan.bottom_layers; }),
        share(
            "density", "share of the inside that the infill deposits",
            [](auto& s) -> auto& { return s.plan.density; }),
        pattern("pattern", "what the infill looks like"),
        angle(
            "angle_deg", "of the infill's lines from X; every other layer crosses",
            [](auto& s) -> auto& { return s.plan.angle; }),
        angle(
            "rotate_deg", "turns the part about the vertical",
            [](auto& s) -> auto& { return s.rotate; }),
        share(
            "infill_overlap", "share of a bead's width by which infill reaches into the wall",
            [](auto& s) -> auto& { return s.plan.infill_overlap; }),
        speed(
            "speed_outer_wall_mm_s", "of the outermost loop",
            [](auto& s) -> auto& { return s.plan.speeds.outer_wall; }),
        speed(
            "speed_wall_mm_s", "of the other loops",
            [](auto& s) -> auto& { return s.plan.speeds.wall; }),
        speed(
            "speed_skin_mm_s", "of solid layers",
            [](auto& s) -> auto& { return s.plan.speeds.skin; }),
        speed(
            "speed_top_skin_mm_s", "of solid layers that are seen from above",
            [](auto& s) -> auto& { return s.plan.speeds.top_skin; }),
        speed(
            "speed_infill_mm_s", "of the infill",
            [](auto& s) -> auto& { return s.plan.speeds.infill; }),
        speed(
            "speed_skirt_mm_s", "of the skirt",
            [](auto& s) -> auto& { return s.plan.speeds.skirt; }),
        speed(
            "speed_first_layer_mm_s", "of everything printed in the first layer",
            [](auto& s) -> auto& { return s.plan.speeds.first_layer; }),
        speed(
            "speed_travel_mm_s", "of moves that print nothing",
            [](auto& s) -> auto& { return s.plan.speeds.travel; }),
        number(
            "first_layer_acceleration_mm_s2", "in the first layer; 0: the printer's usual",
            {0, 1e5}, [](auto& s) -> auto& { return s.plan.first_layer_acceleration; }),
        count(
            "skirt_loops", "loops around the part on the first layer",
            [](auto& s) -> auto& { return s.plan.skirt_loops; }),
        number(
            "skirt_gap_mm", "between part and skirt", {0, 1000},
            [](auto& s) -> auto& { return s.plan.skirt_gap; }),
        number(
            "retract_before_travel_mm", "shorter travel does not pull the filament back",
            {0, 10000}, [](auto& s) -> auto& { return s.plan.retract_before_travel; }),
        number(
            "retract_length_mm", "of filament that is pulled back", {0, 100},
            [](auto& s) -> auto& { return s.retraction.length; }),
        number(
            "retract_speed_mm_s", "of the filament that is pulled back", {0.1, 1000},
            [](auto& s) -> auto& { return s.retraction.speed; }),
        number(
            "closing_gap_mm", "ends of an open outline this near are joined", {0, 100},
            [](auto& s) -> auto& { return s.slice.closing_gap; }),
        number(
            "resolution_mm", "detail below this is dropped from the outlines", {0, 10},
            [](auto& s) -> auto& { return s.slice.resolution; }),
        share(
            "fan", "of the part's fan from the second layer on",
            [](auto& s) -> auto& { return s.fan; }),
        truth(
            "relative_e", "G-code counts filament from the last move, not from the start",
            [](auto& s) -> auto& { return s.relative_e; }),
    };
}

}  // namespace

std::span<const Setting> all_settings() {
    static const std::vector<Setting> settings = table();
    return settings;
}

}  // namespace bead
