#include "job/printer_file.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>

#include "core/error.h"
#include "job/data_file.h"
#include "job/klipper_config.h"
#include "job/limit_table.h"
#include "job/marlin_dump.h"
#include "job/one_line.h"
#include "job/toml_reader.h"

namespace bead {

namespace {

constexpr std::string_view kind = "printer";

constexpr std::array<std::string_view, 4> kinematics_names{"cartesian", "corexy", "corexz",
                                                           "delta"};
constexpr Range fraction{.low = 0, .high = 1};
constexpr Range positive_fraction{.low = 0, .high = 1, .open_low = true};
constexpr Range celsius{.low = -50, .high = 100};  // of the room or the chamber

// Losses of a winding: what the file says of any of the three makes one of currents and resistance.
constexpr std::array currents{"power.motors.run_current_a", "power.motors.hold_current_a",
                              "power.motors.winding_ohm"};
constexpr std::array losses{"power.motors.standing_w", "power.motors.holding_w"};

// The first that the file says.
template <std::size_t n>
std::optional<std::string_view> said(TomlReader& file, const std::array<const char*, n>& keys) {
    for (const char* const key : keys)
        if (file.place_of(key)) return key;
    return {};
}

using PerMotor = std::array<double, 4>;

// A: two windings with the same rms current each lose 2 R I².
double current(double loss, double resistance) {
    return resistance > 0 ? std::sqrt(loss / (2 * resistance)) : 0;
}

// The file has one array of X, Y, Z, E per quantity. A new run current or standing loss is held
// too, unless the file says what is held.
void read_currents(TomlReader& file, std::array<Motor, 4>& motors) {
    PerMotor run{}, hold{}, winding{};
    for (std::size_t i = 0; i < 4; ++i) {
        winding[i] = motors[i].resistance;
        run[i] = current(motors[i].standing, winding[i]);
        hold[i] = current(holding(motors[i]), winding[i]);
    }
    winding = file.numbers(currents[2], winding, not_negative);
    if (file.place_of(currents[0])) hold = run = file.numbers(currents[0], run, not_negative);
    hold = file.numbers(currents[1], hold, not_negative);
    for (std::size_t i = 0; i < 4; ++i) {
        if (motors[i].resistance <= 0 && !file.place_of(currents[0]))
            throw Error(fmt::format(
                "{}: {}: the run current is not known; add {} = [A rms of X, Y, "
                "Z, E]",
                *file.place_of(*said(file, currents)), *said(file, currents), currents[0]));
        if (winding[i] <= 0)
            throw Error(fmt::format(
                "{}: {}: the winding's resistance is not known; add {} = [ohm "
                "of X, Y, Z, E], or say power.motors.standing_w instead",
                *file.place_of(*said(file, currents)), *said(file, currents), currents[2]));
        motors[i].resistance = winding[i];
        motors[i].standing = 2 * winding[i] * run[i] * run[i];
        motors[i].holding = 2 * winding[i] * hold[i] * hold[i];
    }
}

void read_losses(TomlReader& file, std::array<Motor, 4>& motors) {
    PerMotor standing{}, held{};
    for (std::size_t i = 0; i < 4; ++i) {
        standing[i] = motors[i].standing;
        held[i] = holding(motors[i]);
    }
    if (file.place_of(losses[0])) held = standing = file.numbers(losses[0], standing, not_negative);
    held = file.numbers(losses[1], held, not_negative);
    for (std::size_t i = 0; i < 4; ++i) {
        motors[i].standing = standing[i];
        motors[i].holding = held[i];
        motors[i].resistance = 0;
    }
}

void read_windings(TomlReader& file, std::array<Motor, 4>& motors) {
    const auto by_current = said(file, currents), by_loss = said(file, losses);
    if (by_current && by_loss)
        throw Error(fmt::format("{}: {}: the loss is told twice, {} has it too; leave one out",
                                *file.place_of(*by_loss), *by_loss, *by_current));
    if (by_current) read_currents(file, motors);
    if (by_loss) read_losses(file, motors);
    for (std::size_t i = 0; i < 4; ++i)
        if (holding(motors[i]) > motors[i].standing)
            throw Error(
                fmt::format("{}: {}: motor {} would draw more at rest than while it runs; "
                            "hold at most what runs",
                            *file.place_of(by_current ? *by_current : *by_loss),
                            by_current ? currents[1] : losses[1], i + 1));
}

std::array<Motor, 4> read_motors(TomlReader& file, std::array<Motor, 4> motors) {
    const auto read = [&](double Motor::*quantity, std::string_view key, const Range& range) {
        PerMotor values{};
        for (std::size_t i = 0; i < 4; ++i) values[i] = motors[i].*quantity;
        values = file.numbers(key, values, range);
        for (std::size_t i = 0; i < 4; ++i) motors[i].*quantity = values[i];
    };
    read_windings(file, motors);
    read(&Motor::per_speed, "power.motors.per_speed_w_per_mm_s", not_negative);
    read(&Motor::friction, "power.motors.friction_n", not_negative);
    read(&Motor::moving_mass, "power.motors.moving_mass_kg", not_negative);
    read(&Motor::efficiency, "power.motors.efficiency", positive_fraction);
    return motors;
}

// Left out, machines whose motors share axes move the bed with none.
std::optional<std::size_t> read_bed_axis(TomlReader& file, const Printer& printer) {
    constexpr std::array<std::string_view, 4> names{"none", "x", "y", "z"};
    const bool own_axes = printer.kinematics == Kinematics::cartesian;
    const std::optional<std::size_t> usual = own_axes ? printer.power.bed_axis : std::nullopt;
    const std::size_t choice = file.choice("power.motors.bed_axis", usual ? *usual + 1 : 0, names);
    if (choice == 0) return {};
    if (printer.kinematics == Kinematics::delta)
        throw Error(
            fmt::format("{}: power.motors.bed_axis: the bed of a delta stands still; write "
                        "\"none\"",
                        *file.place_of("power.motors.bed_axis")));
    return choice - 1;
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

PowerModel read_power(TomlReader& file, const Printer& printer) {
    const PowerModel& p = printer.power;
    return {.electronics = file.number("power.electronics_w", p.electronics, not_negative),
            .part_fan = file.number("power.part_fan_w", p.part_fan, not_negative),
            .hotend_fan = file.number("power.hotend_fan_w", p.hotend_fan, not_negative),
            .supply_efficiency =
                file.number("power.supply_efficiency", p.supply_efficiency, positive_fraction),
            .ambient = file.number("power.ambient_c", p.ambient, celsius),
            .grid_co2 = file.number("power.grid_co2_g_per_kwh", p.grid_co2, not_negative),
            .motors = read_motors(file, p.motors),
            .standstill_delay =
                file.number("power.motors.standstill_delay_s", p.standstill_delay, not_negative),
            .bed_axis = read_bed_axis(file, printer),
            .hotend = read_hotend(file, p.hotend),
            .bed = read_bed(file, p.bed),
            .uncertainty = read_uncertainty(file, p.uncertainty)};
}

// Left out, a delta has the usual proportions: arms that reach well across the bed.
Delta read_delta(TomlReader& file, double bed, const std::optional<Delta>& known) {
    Delta d = known.value_or(Delta{});
    d.radius = file.number("delta.radius_mm", known ? d.radius : 0.7 * bed, positive);
    d.arm = file.number("delta.arm_mm", known ? d.arm : 1.9 * d.radius,
                        {.low = d.radius, .open_low = true});
    d.head_mass = file.number("delta.head_mass_kg", d.head_mass, not_negative);
    return d;
}

// What a printer has that the text does not say.
struct Basis {
    Printer printer;
    std::optional<Delta> delta;  // nothing: in proportion to the bed
};

PrinterFile read_printer(const DataFile& data, const Basis& basis) {
    TomlReader file(data.text, data.place);
    PrinterFile read{basis.printer, {}};
    Printer& printer = read.printer;
    printer.name = file.text("name", printer.name);
    printer.kinematics = static_cast<Kinematics>(
        file.choice("kinematics", static_cast<std::size_t>(printer.kinematics), kinematics_names));
    printer.bed = file.numbers("bed_mm", printer.bed, positive);
    printer.delta = read_delta(file, printer.bed[0], basis.delta);
    printer.nozzle = file.number("nozzle_mm", printer.nozzle, positive);
    printer.filament = file.number("filament_mm", printer.filament, positive);
    printer.power = read_power(file, printer);
    read.says.limits = stated_limits(file);
    for (const StatedLimit& limit : read.says.limits)
        named_limit(limit.name).put(printer.limits, limit.axis, limit.value);
    file.ignore("vibration");
    file.finish();
    return read;
}

void call_all(Statement& says, const std::string& source) {
    for (StatedLimit& limit : says.limits) limit.source = source;
}

PrinterFile read_toml(const std::string& name_or_file, Printer usual) {
    usual.name = std::filesystem::path(name_or_file).stem().string();
    const DataFile data = data_file(kind, name_or_file);
    PrinterFile read = read_printer(data, {usual, {}});
    if (!name_or_file.ends_with(".toml")) call_all(read.says, data.place);
    return read;
}

// Words as a value need no quotes here, nor do they in the settings of a print.
std::string as_toml(std::string_view setting) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string_view::npos)
        throw Error(fmt::format("--set {}: write it as name=value", setting), Fault::usage);
    const std::string_view name = trimmed(setting.substr(0, equals));
    const std::string_view value = trimmed(setting.substr(equals + 1));
    const bool is_word = !value.empty() && std::isalpha(static_cast<unsigned char>(value[0])) != 0;
    const bool has_meaning =
        value == "true" || value == "false" || value == "inf" || value == "nan";
    return is_word && !has_meaning ? fmt::format("{} = \"{}\"", name, value)
                                   : fmt::format("{} = {}", name, value);
}

}  // namespace

PrinterFile read_printer_file(const std::string& name_or_file) {
    const Printer usual = read_toml(usual_printer, {}).printer;
    if (name_or_file.ends_with(".cfg"))
        return read_klipper_config(file_on_disk(kind, name_or_file), usual);
    if (name_or_file.ends_with(".txt") || name_or_file.ends_with(".log"))
        return read_marlin_dump(file_on_disk(kind, name_or_file), usual);
    return read_toml(name_or_file, usual);
}

Printer load_printer(const std::string& name_or_file) {
    return read_printer_file(name_or_file).printer;
}

PrinterFile with_setting(const Printer& printer, std::string_view setting) {
    PrinterFile read = read_printer({"--set", as_toml(setting)}, {printer, printer.delta});
    call_all(read.says, "--set");
    return read;
}

std::vector<std::string> printer_names() { return data_names(kind); }

}  // namespace bead
