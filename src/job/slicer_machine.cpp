#include "job/slicer_machine.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gcode/number.h"
#include "job/limit_table.h"
#include "job/one_line.h"

namespace bead {
namespace {

constexpr std::string_view prefix = "SLIC3R_";

struct SlicerRow {
    std::string_view setting;  // per axis: with _x, _y, _z, _e
    std::string_view limit;
    bool zero_is_none = false;
};

// Where two rows lead to one limit, the later one counts.
constexpr std::array slicer_rows{
    SlicerRow{"machine_max_feedrate", "max_feedrate_mm_s"},
    SlicerRow{"machine_max_speed", "max_feedrate_mm_s"},  // Bambu Studio, OrcaSlicer
    SlicerRow{"machine_max_acceleration", "max_acceleration_mm_s2"},
    SlicerRow{"machine_max_acceleration_extruding", "acceleration_mm_s2"},
    SlicerRow{"machine_max_acceleration_retracting", "retract_acceleration_mm_s2"},
    SlicerRow{"machine_max_acceleration_travel", "travel_acceleration_mm_s2", true},
    SlicerRow{"machine_max_jerk", "jerk_mm_s"},
    SlicerRow{"machine_max_junction_deviation", "junction_deviation_mm", true},
};
constexpr std::array<std::string_view, 4> axis_endings{"_x", "_y", "_z", "_e"};

char changed_case(char c, char first, char other) {
    return c >= first && c < first + 26 ? char(c - first + other) : c;
}

// What the setting is called where it stands.
std::string called(std::string_view setting, SlicerPlace place) {
    if (place == SlicerPlace::file) return std::string(setting);
    std::string name(prefix);
    for (const char c : setting) name += changed_case(c, 'a', 'A');
    return name;
}

std::string_view value_of(const SlicerSettings& settings, std::string_view name) {
    const auto found = settings.find(name);
    return found == settings.end() ? std::string_view{} : trimmed(found->second);
}

class SlicerReading {
  public:
    SlicerReading(const SlicerSettings& settings, SlicerPlace place, const std::string& where)
        : settings_(settings), place_(place), where_(where) {}

    Statement read() {
        if (value_of(settings_, "machine_limits_usage") != "ignore")
            for (const SlicerRow& row : slicer_rows) take(row);
        says_.firmware = firmware();
        return std::move(says_);
    }

  private:
    void take(const SlicerRow& row) {
        const NamedLimit& limit = named_limit(row.limit);
        if (limit.count == 1) return take(row, row.setting, 0, row.setting);
        for (std::size_t axis = 0; axis < axis_endings.size(); ++axis)
            take(row, std::string(row.setting).append(axis_endings[axis]), axis,
                 std::string(row.setting) + "_*");
    }
    void take(const SlicerRow& row, std::string_view setting, std::size_t axis,
              std::string_view shown) {
        std::string_view text = value_of(settings_, setting);
        text = trimmed(text.substr(0, text.find(',')));
        if (text.empty()) return;
        const Number number = read_number(text.data(), text.data() + text.size(), false);
        const bool is_number = number.end == text.data() + text.size();
        if (is_number && is_allowed(named_limit(row.limit), number.value))
            says_.limits.push_back({row.limit, axis, number.value,
                                    fmt::format("{} ({})", where_, called(shown, place_))});
        else if (!is_number || number.value != 0 || !row.zero_is_none)
            says_.warnings.push_back(fmt::format("{}: {} = {} is no limit above 0; passed over",
                                                 where_, called(setting, place_), one_line(text)));
    }

    // "marlin" is the Marlin of old to the slicers, whose planner lives on in Prusa's 8-bit
    // firmware.
    [[nodiscard]] std::optional<FirmwareChoice> firmware() const {
        const std::string_view flavor = value_of(settings_, "gcode_flavor");
        const bool deviation = std::ranges::any_of(says_.limits, [](const StatedLimit& limit) {
            return limit.name == "junction_deviation_mm";
        });
        const auto choice = [&](Firmware firmware) {
            return FirmwareChoice{firmware, fmt::format("{} ({} = {})", where_,
                                                        called("gcode_flavor", place_), flavor)};
        };
        if (flavor == "klipper") return choice(Firmware::klipper);
        if (flavor == "marlin") return choice(Firmware::prusa);
        if (flavor == "marlin2" || flavor == "reprapfirmware")
            return choice(deviation ? Firmware::marlin_jd : Firmware::marlin_jerk);
        return std::nullopt;
    }

    const SlicerSettings& settings_;
    SlicerPlace place_;
    const std::string& where_;
    Statement says_;
};

}  // namespace

Statement slicer_statement(const SlicerSettings& settings, SlicerPlace place,
                           const std::string& where) {
    return SlicerReading(settings, place, where).read();
}

SlicerSettings slicer_environment(const char* const* environment) {
    SlicerSettings settings;
    for (; environment != nullptr && *environment != nullptr; ++environment) {
        const std::string_view entry = *environment;
        const auto equals = entry.find('=');
        if (!entry.starts_with(prefix) || equals == std::string_view::npos) continue;
        std::string name;
        for (const char c : entry.substr(prefix.size(), equals - prefix.size()))
            name += changed_case(c, 'A', 'a');
        settings[name] = entry.substr(equals + 1);
    }
    return settings;
}

}  // namespace bead
