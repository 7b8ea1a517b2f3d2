#include "job/printer_file.h"

#include <filesystem>

#include "job/data_file.h"
#include "job/toml_reader.h"

namespace bead {

namespace {

constexpr std::string_view kind = "printer";
constexpr const char* usual = "prusa-mk3s";

constexpr std::array<std::string_view, 4> kinematics_names{"cartesian", "corexy", "corexz",
                                                           "delta"};
constexpr Range fraction{.low = 0, .high = 1};
constexpr Range positive_fraction{.low = 0, .high = 1, .open_low = true};
constexpr Range celsius{.low = -50, .high = 100};  // of the room or the chamber

Limits read_limits(TomlReader& file, const Limits& usually) {
    Limits l = usually;
    l.steps_per_mm = file.numbers("limits.steps_per_mm", l.steps_per_mm, positive);
    l.max_feedrate = file.numbers("limits.max_feedrate_mm_s", l.max_feedrate, positive);
    l.max_acceleration =
        file.numbers("limits.max_acceleration_mm_s2", l.max_acceleration, positive);
    l.jerk = file.numbers("limits.jerk_mm_s", l.jerk, positive);
    const auto read = [&](double& value, std::string_view key, const Range& range) {
        value = file.number(key, value, range);
    };
    read(l.acceleration, "limits.acceleration_mm_s2", positive);
    read(l.retract_acceleration, "limits.retract_acceleration_mm_s2", positive);
    read(l.travel_acceleration, "limits.travel_acceleration_mm_s2", positive);
    read(l.junction_deviation, "limits.junction_deviation_mm", not_negative);
    read(l.square_corner_velocity, "limits.square_corner_velocity_mm_s", not_negative);
    read(l.minimum_cruise_ratio, "limits.minimum_cruise_ratio", fraction);
    read(l.extrude_only_velocity, "limits.extrude_only_velocity_mm_s", positive);
    read(l.extrude_only_acceleration, "limits.extrude_only_acceleration_mm_s2", positive);
    read(l.instantaneous_corner_velocity, "limits.instantaneous_corner_velocity_mm_s", positive);
    read(l.arc_resolution, "limits.arc_resolution_mm", positive);
    l.drop_segments =
        file.integer("limits.drop_segments_steps", l.drop_segments, {.low = 0, .high = 1000});
    l.slowdown = file.flag("limits.slowdown", l.slowdown);
    return l;
}

// The file has one array of X, Y, Z, E per quantity.
std::array<Motor, 4> read_motors(TomlReader& file, std::array<Motor, 4> motors) {
    const auto read = [&](double Motor::*quantity, std::string_view key, const Range& range) {
        std::array<double, 4> values{};
        for (std::size_t i = 0; i < 4; ++i) values[i] = motors[i].*quantity;
        values = file.numbers(key, values, range);
        for (std::size_t i = 0; i < 4; ++i) motors[i].*quantity = values[i];
    };
    read(&Motor::standing, "power.motors.standing_w", not_negative);
    read(&Motor::per_speed, "power.motors.per_speed_w_per_mm_s", not_negative);
    read(&Motor::friction, "power.motors.friction_n", not_negative);
    read(&Motor::moving_mass, "power.motors.moving_mass_kg", not_negative);
    read(&Motor::efficiency, "power.motors.efficiency", positive_fraction);
    return motors;
}

HotEnd read_hotend(TomlReader& file, const HotEnd& h) {
    return {.heater = file.number("power.hotend.heater_w", h.heater, not_negative),
            .capacity = file.number("power.hotend.capacity_j_k", h.capacity, positive),
            .resistance_still =
                file.number("power.hotend.resistance_still_k_w", h.resistance_still, positive),
            .resistance_blown =
                file.number("power.hotend.resistance_blown_k_w", h.resistance_blown, positive)};
}

BedHeater read_bed(TomlReader& file, const BedHeater& b) {
    return {.heater = file.number("power.bed.heater_w", b.heater, not_negative),
            .capacity = file.number("power.bed.capacity_j_k", b.capacity, positive),
            .resistance = file.number("power.bed.resistance_k_w", b.resistance, positive),
            .mains = file.flag("power.bed.mains", b.mains)};
}

PowerUncertainty read_uncertainty(TomlReader& file, const PowerUncertainty& u) {
    return {.bed = file.number("power.uncertainty.bed", u.bed, fraction),
            .hotend = file.number("power.uncertainty.hotend", u.hotend, fraction),
            .motors = file.number("power.uncertainty.motors", u.motors, fraction),
            .fans = file.number("power.uncertainty.fans", u.fans, fraction),
            .electronics = file.number("power.uncertainty.electronics", u.electronics, fraction),
            .supply = file.number("power.uncertainty.supply", u.supply, fraction)};
}

PowerModel read_power(TomlReader& file, const PowerModel& p) {
    return {.electronics = file.number("power.electronics_w", p.electronics, not_negative),
            .part_fan = file.number("power.part_fan_w", p.part_fan, not_negative),
            .hotend_fan = file.number("power.hotend_fan_w", p.hotend_fan, not_negative),
            .supply_efficiency =
                file.number("power.supply_efficiency", p.supply_efficiency, positive_fraction),
            .ambient = file.number("power.ambient_c", p.ambient, celsius),
            .grid_co2 = file.number("power.grid_co2_g_per_kwh", p.grid_co2, not_negative),
            .motors = read_motors(file, p.motors),
            .hotend = read_hotend(file, p.hotend),
            .bed = read_bed(file, p.bed),
            .uncertainty = read_uncertainty(file, p.uncertainty)};
}

// Left out, a delta has the usual proportions: arms that reach well across the bed.
Delta read_delta(TomlReader& file, double bed) {
    Delta d;
    d.radius = file.number("delta.radius_mm", 0.7 * bed, positive);
    d.arm = file.number("delta.arm_mm", 1.9 * d.radius, {.low = d.radius, .open_low = true});
    d.head_mass = file.number("delta.head_mass_kg", d.head_mass, not_negative);
    return d;
}

Printer read_printer(const DataFile& data, const std::string& name, const Printer& usually) {
    TomlReader file(data.text, data.place);
    Printer printer;
    printer.name = file.text("name", name);
    printer.kinematics = static_cast<Kinematics>(
        file.choice("kinematics", static_cast<std::size_t>(usually.kinematics), kinematics_names));
    printer.bed = file.numbers("bed_mm", usually.bed, positive);
    printer.delta = read_delta(file, printer.bed[0]);
    printer.nozzle = file.number("nozzle_mm", usually.nozzle, positive);
    printer.filament = file.number("filament_mm", usually.filament, positive);
    printer.limits = read_limits(file, usually.limits);
    printer.power = read_power(file, usually.power);
    file.ignore("vibration");
    file.finish();
    return printer;
}

}  // namespace

Printer load_printer(const std::string& name_or_file) {
    const DataFile data = data_file(kind, name_or_file);
    const Printer usually = read_printer(data_file(kind, usual), usual, {});
    return read_printer(data, std::filesystem::path(name_or_file).stem().string(), usually);
}

std::vector<std::string> printer_names() { return data_names(kind); }

}  // namespace bead
