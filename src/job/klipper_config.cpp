#include "job/klipper_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "job/ini_sections.h"
#include "job/limit_table.h"
#include "job/one_line.h"

namespace bead {
namespace {

constexpr Range above_zero{.low = 1e-6, .high = 1e9};
constexpr Range not_below_zero{.low = 0, .high = 1e9};

// A value and where it came from.
struct Found {
    double value = 0;
    std::string source;
};

std::optional<double> klipper_number(std::string_view text) {
    double value = 0;
    const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc() || stop != text.data() + text.size()) return std::nullopt;
    return value;
}

// The configuration while it is read into a PrinterFile.
class KlipperConfig {
  public:
    KlipperConfig(const DataFile& data, const Printer& usual)
        : place_(data.place), ini_(ini_sections(data)), read_{usual, {}} {}

    PrinterFile read() {
        check_complete();
        read_kinematics();
        read_head();
        read_extruder();
        read_bed();
        read_steps();
        state("arc_resolution_mm", 0,
              find_or("gcode_arcs", "resolution", above_zero, {1, by_default}));
        for (const StatedLimit& limit : read_.says.limits)
            named_limit(limit.name).put(read_.printer.limits, limit.axis, limit.value);
        remark();
        return std::move(read_);
    }

  private:
    [[nodiscard]] const IniValue* text(std::string_view section, std::string_view name) const {
        const auto found = ini_.sections.find(section);
        if (found == ini_.sections.end()) return nullptr;
        const auto value = found->second.find(name);
        return value == found->second.end() ? nullptr : &value->second;
    }
    [[nodiscard]] std::optional<Found> find(std::string_view section, std::string_view name,
                                            const Range& range) const {
        const IniValue* const told = text(section, name);
        if (told == nullptr) return std::nullopt;
        const std::optional<double> value = klipper_number(told->text);
        if (!value || !(*value >= range.low && *value <= range.high))
            throw Error(fmt::format("{}: {} is {} but must be a number {} {:g}", told->place, name,
                                    one_line(told->text),
                                    range.low > 0 ? "above 0 and at most" : "from 0 to",
                                    range.high));
        return Found{*value, fmt::format("{} ({})", told->place, name)};
    }
    [[nodiscard]] Found find_or(std::string_view section, std::string_view name, const Range& range,
                                const Found& fallback) const {
        return find(section, name, range).value_or(fallback);
    }
    void state(std::string_view limit, std::size_t axis, const Found& found) {
        read_.says.limits.push_back({limit, axis, found.value, found.source});
    }

    void check_complete() const {
        for (const char* name : {"max_velocity", "max_accel"})
            if (text("printer", name) == nullptr)
                throw Error(fmt::format(
                    "{}: has no [printer] with {}{}; name the file that has it", place_, name,
                    ini_.includes.empty() ? "" : " (what it includes is not followed)"));
    }

    void read_kinematics() {
        read_.printer.name = place_;
        read_.says.firmware = FirmwareChoice{Firmware::klipper, place_};
        const IniValue* const told = text("printer", "kinematics");
        if (told == nullptr) return;
        constexpr std::array<std::string_view, 4> names{"cartesian", "corexy", "corexz", "delta"};
        const auto found = std::ranges::find(names, told->text);
        if (found != names.end())
            read_.printer.kinematics = static_cast<Kinematics>(found - names.begin());
        else
            read_.says.warnings.push_back(
                fmt::format("{}: kinematics {} is not known here; motion is planned all the same, "
                            "motors are those of a {} machine",
                            told->place, one_line(told->text),
                            names[static_cast<std::size_t>(read_.printer.kinematics)]));
    }

    // What Klipper derives the rest from: velocity and acceleration of the head.
    void read_head() {
        velocity_ = *find("printer", "max_velocity", above_zero);
        acceleration_ = *find("printer", "max_accel", above_zero);
        for (const std::size_t axis : {0U, 1U}) {
            state("max_feedrate_mm_s", axis, velocity_);
            state("max_acceleration_mm_s2", axis, acceleration_);
        }
        state("max_feedrate_mm_s", 2, find_or("printer", "max_z_velocity", above_zero, velocity_));
        state("max_acceleration_mm_s2", 2,
              find_or("printer", "max_z_accel", above_zero, acceleration_));
        state("acceleration_mm_s2", 0, acceleration_);
        state("travel_acceleration_mm_s2", 0, acceleration_);
        state("square_corner_velocity_mm_s", 0,
              find_or("printer", "square_corner_velocity", not_below_zero, {5, by_default}));
        state("minimum_cruise_ratio", 0, cruise_ratio());
    }
    [[nodiscard]] Found cruise_ratio() const {
        constexpr Range below_one{.low = 0, .high = 0.999999};
        if (const auto ratio = find("printer", "minimum_cruise_ratio", below_one)) return *ratio;
        const auto older = find("printer", "max_accel_to_decel", above_zero);
        if (!older) return {0.5, by_default};
        return {1 - std::min(1.0, older->value / acceleration_.value), older->source};
    }

    // The filament alone may go as fast as in a bead of four nozzle diameters squared.
    void read_extruder() {
        Printer& printer = read_.printer;
        if (const auto found = find("extruder", "nozzle_diameter", above_zero))
            printer.nozzle = found->value;
        if (const auto found = find("extruder", "filament_diameter", above_zero))
            printer.filament = found->value;
        const double filament = std::numbers::pi / 4 * printer.filament * printer.filament;
        const double ratio = 4 * printer.nozzle * printer.nozzle / filament;
        const Found velocity =
            find_or("extruder", "max_extrude_only_velocity", above_zero,
                    {ratio * velocity_.value, place_ + " (from max_velocity, as Klipper does)"});
        const Found acceleration =
            find_or("extruder", "max_extrude_only_accel", above_zero,
                    {ratio * acceleration_.value, place_ + " (from max_accel, as Klipper does)"});
        state("extrude_only_velocity_mm_s", 0, velocity);
        state("max_feedrate_mm_s", 3, velocity);
        state("extrude_only_acceleration_mm_s2", 0, acceleration);
        state("max_acceleration_mm_s2", 3, acceleration);
        state("retract_acceleration_mm_s2", 0, acceleration);
        state("instantaneous_corner_velocity_mm_s", 0,
              find_or("extruder", "instantaneous_corner_velocity", above_zero, {1, by_default}));
    }

    void read_bed() {
        constexpr std::array steppers{"stepper_x", "stepper_y", "stepper_z"};
        Printer& printer = read_.printer;
        for (std::size_t i = 0; i < steppers.size(); ++i)
            if (const auto found = find(steppers[i], "position_max", above_zero))
                printer.bed[i] = found->value;
        if (printer.kinematics != Kinematics::delta) return;
        if (const auto radius = find("printer", "delta_radius", above_zero))
            printer.delta.radius = radius->value;
        const double reach =
            find_or("printer", "print_radius", above_zero, {printer.delta.radius, ""}).value;
        printer.bed[0] = printer.bed[1] = 2 * reach;
        if (const auto height = find("stepper_a", "position_endstop", above_zero))
            printer.bed[2] = height->value;
        if (const auto arm = find("stepper_a", "arm_length", above_zero))
            printer.delta.arm = arm->value;
    }

    void read_steps() {
        const bool towers = read_.printer.kinematics == Kinematics::delta;
        const std::array<std::string_view, 4> steppers{
            towers ? "stepper_a" : "stepper_x", towers ? "stepper_b" : "stepper_y",
            towers ? "stepper_c" : "stepper_z", "extruder"};
        for (std::size_t i = 0; i < steppers.size(); ++i)
            if (const auto found = steps(steppers[i])) state("steps_per_mm", i, *found);
    }
    [[nodiscard]] std::optional<Found> steps(std::string_view stepper) const {
        if (const auto older = find(stepper, "step_distance", above_zero))
            return Found{1 / older->value, older->source};
        const auto way = find(stepper, "rotation_distance", above_zero);
        const auto micro = find(stepper, "microsteps", above_zero);
        if (!way || !micro) return std::nullopt;
        const Found full = find_or(stepper, "full_steps_per_rotation", above_zero, {200, ""});
        return Found{full.value * micro->value * gear_ratio(stepper) / way->value, way->source};
    }
    // "80:16, 57:11"
    [[nodiscard]] double gear_ratio(std::string_view stepper) const {
        const IniValue* const told = text(stepper, "gear_ratio");
        if (told == nullptr) return 1;
        double ratio = 1;
        std::string_view rest = told->text;
        while (!rest.empty()) {
            const std::string_view pair = rest.substr(0, rest.find(','));
            rest.remove_prefix(std::min(rest.size(), pair.size() + 1));
            const auto colon = std::min(pair.find(':'), pair.size());
            const auto from = klipper_number(trimmed(pair.substr(0, colon)));
            const auto to = klipper_number(trimmed(pair.substr(std::min(colon + 1, pair.size()))));
            if (!from || !to || !(*from > 0 && *from <= 1e9) || !(*to > 0 && *to <= 1e9))
                throw Error(fmt::format("{}: gear_ratio is {} but must be like 80:16, 57:11",
                                        told->place, one_line(told->text)));
            ratio *= *from / *to;
        }
        return ratio;
    }

    void remark() {
        for (const std::string& file : ini_.includes)
            read_.says.warnings.push_back(
                fmt::format("{}: [include {}] is not followed; what it sets is not known", place_,
                            one_line(file)));
        read_.says.notes.push_back(
            fmt::format("{}: says nothing of power; that is as of {}", place_, usual_printer));
    }

    static constexpr const char* by_default = "Klipper's default";
    std::string place_;
    IniSections ini_;
    PrinterFile read_;
    Found velocity_, acceleration_;
};

}  // namespace

PrinterFile read_klipper_config(const DataFile& config, const Printer& usual) {
    return KlipperConfig(config, usual).read();
}

}  // namespace bead
