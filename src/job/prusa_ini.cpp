#include "job/prusa_ini.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "core/error.h"
#include "job/one_line.h"

namespace bead {
namespace {

enum class Form {
    plain,       // as our setting takes it
    part_of,     // as plain, or a percentage of the setting `whole`
    share_of,    // a percentage, or an amount that is to be divided by the setting `whole`
    as_pattern,  // PrusaSlicer's name of a pattern
};

struct IniRow {
    std::string_view prusa, setting;
    Form form = Form::plain;
    std::string_view whole = {};  // stands above in the table; none: a percentage cannot be used
    bool zero_is_auto = false;    // 0: PrusaSlicer computes the value
};

constexpr std::array ini_rows{
    IniRow{"layer_height", "layer_height_mm"},
    IniRow{"first_layer_height", "first_layer_height_mm", Form::part_of, "layer_height_mm"},
    IniRow{"perimeters", "walls"},
    IniRow{"top_solid_layers", "top_layers"},
    IniRow{"bottom_solid_layers", "bottom_layers"},
    IniRow{"fill_density", "density"},
    IniRow{"fill_pattern", "pattern", Form::as_pattern},
    IniRow{"fill_angle", "angle_deg"},
    IniRow{"extrusion_width", "bead_width_mm", Form::part_of, "", true},
    IniRow{"first_layer_extrusion_width", "first_layer_width_mm", Form::part_of, "", true},
    IniRow{"infill_overlap", "infill_overlap", Form::share_of, "bead_width_mm"},
    IniRow{"perimeter_speed", "speed_wall_mm_s", Form::plain, "", true},
    IniRow{"external_perimeter_speed", "speed_outer_wall_mm_s", Form::part_of, "speed_wall_mm_s",
           true},
    IniRow{"infill_speed", "speed_infill_mm_s", Form::plain, "", true},
    IniRow{"solid_infill_speed", "speed_skin_mm_s", Form::part_of, "speed_infill_mm_s", true},
    IniRow{"top_solid_infill_speed", "speed_top_skin_mm_s", Form::part_of, "speed_skin_mm_s", true},
    IniRow{"first_layer_speed", "speed_first_layer_mm_s", Form::part_of, "", true},
    IniRow{"travel_speed", "speed_travel_mm_s"},
    IniRow{"skirts", "skirt_loops"},
    IniRow{"skirt_distance", "skirt_gap_mm"},
    IniRow{"retract_length", "retract_length_mm"},
    IniRow{"retract_speed", "retract_speed_mm_s"},
    IniRow{"retract_before_travel", "retract_before_travel_mm"},
    IniRow{"use_relative_e_distances", "relative_e"},
    IniRow{"first_layer_acceleration", "first_layer_acceleration_mm_s2"},
};

// What is here the same pattern under another name, or the same name.
struct SamePattern {
    std::string_view prusa, ours;
};
constexpr std::array same_patterns{
    SamePattern{"rectilinear", "rectilinear"},
    SamePattern{"concentric", "concentric"},
    SamePattern{"hilbertcurve", "hilbert"},
    SamePattern{"archimedeanchords", "archimedean"},
    SamePattern{"octagramspiral", "octagram"},
    SamePattern{"line", "line"},
    SamePattern{"grid", "grid"},
    SamePattern{"triangles", "triangles"},
    SamePattern{"stars", "tri-hexagon"},
    SamePattern{"gyroid", "gyroid"},
};

struct Entry {
    std::string_view key, value;
    std::string where;  // file:line
};

std::vector<Entry> entries(std::string_view text, const std::string& file) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::vector<Entry> found;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line[0] == '#' || line[0] == ';') continue;
        const std::string where = fmt::format("{}:{}", file, number);
        if (line[0] == '[')
            throw Error(where + ": a bundle of presets; export a single configuration instead");
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos)
            throw Error(
                fmt::format("{}: {} is not of the form name = value", where, one_line(line)));
        found.push_back({trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)), where});
    }
    return found;
}

std::optional<double> ini_number(std::string_view text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

// The value for our setting, or why there is none.
struct Translation {
    std::string value, unusable;
};

double current(const Settings& settings, std::string_view name) {
    return ini_number(get(settings, name)).value_or(0);
}

Translation translated_part(const Settings& settings, const IniRow& row, std::string_view text) {
    if (!text.ends_with('%')) return {std::string(text), ""};
    if (row.whole.empty()) return {"", "a percentage"};
    const std::optional<double> percent = ini_number(trimmed(text.substr(0, text.size() - 1)));
    if (!percent) return {std::string(text), ""};
    return {fmt::format("{}", *percent / 100 * current(settings, row.whole)), ""};
}

Translation translated_share(const Settings& settings, const IniRow& row, std::string_view text) {
    const std::optional<double> amount = ini_number(text);
    if (!amount) return {std::string(text), ""};
    return {fmt::format("{}", *amount / current(settings, row.whole)), ""};
}

Translation translated_pattern(std::string_view text) {
    const auto* const same = std::ranges::find(same_patterns, text, &SamePattern::prusa);
    if (same == same_patterns.end()) return {"", "not available"};
    return {std::string(same->ours), ""};
}

Translation translated(const Settings& settings, const IniRow& row, std::string_view text) {
    if (row.zero_is_auto && ini_number(text) == 0.0) return {"", "automatic"};
    switch (row.form) {
        case Form::part_of:
            return translated_part(settings, row, text);
        case Form::share_of:
            return translated_share(settings, row, text);
        case Form::as_pattern:
            return translated_pattern(text);
        case Form::plain:
            break;
    }
    return {std::string(text), ""};
}

// Sets what the row names; returns what to say if the value cannot be used, else nothing.
std::string apply(Settings& settings, const IniRow& row, const Entry& entry) {
    // Settings of a tool are lists; the first is the first extruder's.
    const std::string_view text = trimmed(entry.value.substr(0, entry.value.find(',')));
    const Translation found = translated(settings, row, text);
    if (!found.unusable.empty())
        return fmt::format("{}={} ({}; {} is used)", row.prusa, one_line(text), found.unusable,
                           get(settings, row.setting));
    set(settings, row.setting, found.value, fmt::format("{}: {}", entry.where, row.prusa));
    return "";
}

}  // namespace

std::vector<std::string> read_prusa_ini(Settings& settings, std::string_view text,
                                        const std::string& file) {
    const std::vector<Entry> all = entries(text, file);
    std::map<std::string_view, const Entry*> by_key;
    for (const Entry& entry : all) by_key[entry.key] = &entry;

    std::map<std::string_view, std::string> notes;  // "" for what was taken
    for (const IniRow& row : ini_rows)
        if (const auto entry = by_key.find(row.prusa); entry != by_key.end())
            notes[row.prusa] = apply(settings, row, *entry->second);

    std::vector<std::string> ignored;
    for (const Entry& entry : all) {
        if (by_key[entry.key] != &entry) continue;
        const auto note = notes.find(entry.key);
        if (note == notes.end())
            ignored.push_back(one_line(entry.key));
        else if (!note->second.empty())
            ignored.push_back(note->second);
    }
    return ignored;
}

}  // namespace bead
