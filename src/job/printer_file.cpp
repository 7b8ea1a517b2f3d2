#include "job/printer_file.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <optional>

#include "core/error.h"
#include "job/data_file.h"
#include "job/klipper_config.h"
#include "job/limit_table.h"
#include "job/marlin_dump.h"
#include "job/motor_table.h"
#include "job/one_line.h"
#include "job/toml_reader.h"
#include "job/vibration_table.h"

namespace bead {

namespace {

constexpr std::string_view printer_kind = "printer";

constexpr std::array<std::string_view, 4> kinematics_names{"cartesian", "corexy", "corexz",
                                                           "delta"};
constexpr Range any_share{.low = 0, .high = 1};
constexpr Range some_share{.low = 0, .high = 1, .open_low = true};
constexpr Range air_celsius{.low = -50, .high = 100};  // of the room or the chamber

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
    return {.bed = file.number("power.uncertainty.bed", u.bed, any_share),
            .hotend = file.number("power.uncertainty.hotend", u.hotend, any_share),
            .motors = file.number("power.uncertainty.motors", u.motors, any_share),
            .fans = file.number("power.uncertainty.fans", u.fans, any_share),
            .electronics = file.number("power.uncertainty.electronics", u.electronics, any_share),
            .supply = file.number("power.uncertainty.supply", u.supply, any_share)};
}

PowerModel read_power(TomlReader& file, const Printer& printer) {
    const PowerModel& p = printer.power;
    return {.electronics = file.number("power.electronics_w", p.electronics, not_negative),
            .part_fan = file.number("power.part_fan_w", p.part_fan, not_negative),
            .hotend_fan = file.number("power.hotend_fan_w", p.hotend_fan, not_negative),
            .supply_efficiency =
                file.number("power.supply_efficiency", p.supply_efficiency, some_share),
            .ambient = file.number("power.ambient_c", p.ambient, air_celsius),
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
    printer.vibration = read_vibration(file, printer.vibration);
    printer.vibration.energy_co2 = printer.power.grid_co2 / 1000;
    file.finish();
    return read;
}

void call_all(Statement& says, const std::string& source) {
    for (StatedLimit& limit : says.limits) limit.source = source;
}

PrinterFile read_toml(const std::string& name_or_file, Printer usual) {
    usual.name = std::filesystem::path(name_or_file).stem().string();
    const DataFile data = data_file(printer_kind, name_or_file);
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
        return read_klipper_config(file_on_disk(printer_kind, name_or_file), usual);
    if (name_or_file.ends_with(".txt") || name_or_file.ends_with(".log"))
        return read_marlin_dump(file_on_disk(printer_kind, name_or_file), usual);
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

std::vector<std::string> printer_names() { return data_names(printer_kind); }

}  // namespace bead
