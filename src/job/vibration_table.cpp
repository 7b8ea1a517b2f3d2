#include "job/vibration_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "vibration/drive.h"

namespace bead {
namespace {

constexpr Range efficiency_range{.low = 0, .high = 1, .open_low = true};
constexpr Range light_damping{.low = 0, .high = 0.49};  // more and there is no mode to speak of
constexpr Range mode_frequency{.low = 0, .high = highest_mode, .open_low = true};

constexpr std::array mode_keys{"vibration.frequency_hz", "vibration.damping_ratio"};

using Quantity = double& (*)(DriveAxis&);
struct VibrationRow {
    const char* key;
    double unit;  // of the file in SI
    Range range;
    Quantity of;
};

constexpr VibrationRow vibration_rows[] = {
    {"vibration.slave_mass_kg", 1, positive, [](DriveAxis& a) -> double& { return a.slave_mass; }},
    {"vibration.table_mass_kg", 1, positive, [](DriveAxis& a) -> double& { return a.table_mass; }},
    {"vibration.flexure_n_per_mm", 1e3, positive,
     [](DriveAxis& a) -> double& { return a.flexure; }},
    {"vibration.flexure_damping_ratio", 1, light_damping,
     [](DriveAxis& a) -> double& { return a.flexure_damping; }},
    {"vibration.screw_damping_ratio", 1, light_damping,
     [](DriveAxis& a) -> double& { return a.screw_damping; }},
    {"vibration.screw.radius_mm", 1e-3, positive,
     [](DriveAxis& a) -> double& { return a.screw.radius; }},
    {"vibration.screw.length_mm", 1e-3, positive,
     [](DriveAxis& a) -> double& { return a.screw.length; }},
    {"vibration.screw.lead_mm", 1e-3, positive,
     [](DriveAxis& a) -> double& { return a.screw.lead; }},
    {"vibration.screw.nut_distance_mm", 1e-3, positive,
     [](DriveAxis& a) -> double& { return a.screw.nut_distance; }},
    {"vibration.screw.density_kg_m3", 1, positive,
     [](DriveAxis& a) -> double& { return a.screw.density; }},
    {"vibration.screw.young_gpa", 1e9, positive,
     [](DriveAxis& a) -> double& { return a.screw.young; }},
    {"vibration.screw.shear_gpa", 1e9, positive,
     [](DriveAxis& a) -> double& { return a.screw.shear; }},
    {"vibration.screw.rotor_mass_kg", 1, not_negative,
     [](DriveAxis& a) -> double& { return a.screw.rotor_mass; }},
    {"vibration.screw.coupling_mass_kg", 1, not_negative,
     [](DriveAxis& a) -> double& { return a.screw.coupling_mass; }},
    {"vibration.screw.rotor_inertia_kg_mm2", 1e-6, positive,
     [](DriveAxis& a) -> double& { return a.screw.rotor_inertia; }},
    {"vibration.screw.coupling_inertia_kg_mm2", 1e-6, not_negative,
     [](DriveAxis& a) -> double& { return a.screw.coupling_inertia; }},
    {"vibration.screw.bearing_n_per_um", 1e6, positive,
     [](DriveAxis& a) -> double& { return a.screw.bearing_stiffness; }},
    {"vibration.screw.coupling_nm_per_rad", 1, positive,
     [](DriveAxis& a) -> double& { return a.screw.coupling_stiffness; }},
    {"vibration.screw.nut_n_per_um", 1e6, positive,
     [](DriveAxis& a) -> double& { return a.screw.nut_stiffness; }},
    {"vibration.screw.nut_preload", 1, efficiency_range,
     [](DriveAxis& a) -> double& { return a.screw.nut_preload; }},
    {"vibration.servo.bandwidth_hz", 1, positive,
     [](DriveAxis& a) -> double& { return a.servo.bandwidth; }},
    {"vibration.servo.damping_ratio", 1, positive,
     [](DriveAxis& a) -> double& { return a.servo.damping; }},
    {"vibration.servo.friction_nm", 1, not_negative,
     [](DriveAxis& a) -> double& { return a.servo.friction; }},
    {"vibration.servo.rolling_friction", 1, not_negative,
     [](DriveAxis& a) -> double& { return a.servo.rolling; }},
    {"vibration.servo.torque_constant_nm_per_a", 1, positive,
     [](DriveAxis& a) -> double& { return a.servo.torque_constant; }},
    {"vibration.servo.resistance_ohm", 1, not_negative,
     [](DriveAxis& a) -> double& { return a.servo.resistance; }},
};

[[noreturn]] void reject(TomlReader& file, std::string_view key, const std::string& what) {
    const std::string place = file.place_of(key).value_or("[vibration]");
    throw Error(fmt::format("{}: {}: {}", place, key, what),
                place.starts_with("--") ? Fault::usage : Fault::input);
}

void read_rows(TomlReader& file, std::array<DriveAxis, 2>& axes) {
    for (const VibrationRow& row : vibration_rows) {
        std::array<double, 2> values{row.of(axes[0]) / row.unit, row.of(axes[1]) / row.unit};
        if (!file.place_of(row.key)) {
            file.numbers(row.key, values, row.range);  // a key of the file all the same
            continue;
        }
        values = file.numbers(row.key, values, row.range);
        for (std::size_t k = 0; k < 2; ++k) row.of(axes[k]) = values[k] * row.unit;
    }
}

void read_screw(TomlReader& file, std::array<DriveAxis, 2>& axes) {
    constexpr std::array<std::string_view, 2> supports{"fixed-free", "fixed-fixed"};
    constexpr const char* coupling = "vibration.screw.coupling_at_mm";
    const std::size_t support =
        file.choice("vibration.screw.support", std::size_t(axes[0].screw.support), supports);
    std::array<double, 2> at = file.numbers<2>(coupling, {});
    const bool known = file.place_of(coupling).has_value();
    for (std::size_t k = 0; k < 2; ++k) {
        Screw& screw = axes[k].screw;
        screw.support = ScrewSupport(support);
        if (known) screw.coupling_at = at[k] * 1e-3;
        if (screw.nut_distance >= screw.length)
            reject(file, "vibration.screw.nut_distance_mm",
                   fmt::format("the nut of {} would be beyond its screw of {:g} mm", "XY"[k],
                               screw.length * 1e3));
    }
}

void read_modes(TomlReader& file, std::array<DriveAxis, 2>& axes) {
    constexpr const char *frequency = "vibration.frequency_hz",
                         *damping = "vibration.damping_ratio";
    const bool told = file.place_of(frequency) || file.place_of(damping);
    std::array<double, 2> f{}, zeta{};
    for (std::size_t k = 0; k < 2; ++k) {
        const DriveMode mode = first_mode(axes[k]);
        f[k] = mode.frequency;
        zeta[k] = mode.damping;
    }
    f = file.numbers(frequency, f, mode_frequency);
    zeta = file.numbers(damping, zeta, light_damping);
    if (!told) return;
    for (std::size_t k = 0; k < 2; ++k) axes[k] = with_mode(axes[k], {f[k], zeta[k]});
}

void check_modes(TomlReader& file, const std::array<DriveAxis, 2>& axes) {
    for (std::size_t k = 0; k < 2; ++k) {
        const DriveMode mode = first_mode(axes[k]);
        if (mode.frequency > 0 && mode.frequency <= highest_mode * (1 + 1e-9) &&
            mode.damping < 0.5 && mode.damping >= 0)
            continue;
        reject(file, "vibration.flexure_n_per_mm",
               fmt::format(
                   "the first mode of {} would be at {:.1f} Hz with a damping ratio of {:.2f}; "
                   "it must be above 0 and at most {:g} Hz, the ratio below 0.5",
                   "XY"[k], mode.frequency, mode.damping, highest_mode));
    }
}

bool says_anything(TomlReader& file) {
    const auto said = [&](const char* key) {
        const auto place = file.place_of(key);
        return place && !place->starts_with("--");
    };
    return said(mode_keys[0]) || said(mode_keys[1]) ||
           std::ranges::any_of(vibration_rows,
                               [&](const VibrationRow& row) { return said(row.key); });
}

}  // namespace

VibrationModel read_vibration(TomlReader& file, const VibrationModel& base) {
    VibrationModel model = says_anything(file) ? VibrationModel{} : base;
    read_rows(file, model.axes);
    read_screw(file, model.axes);
    read_modes(file, model.axes);
    check_modes(file, model.axes);
    model.base_power = file.number("vibration.base_power_w", model.base_power, not_negative);
    model.melt_efficiency =
        file.number("vibration.melt_efficiency", model.melt_efficiency, efficiency_range);
    model.material_co2 =
        file.number("vibration.material_co2_kg_per_kg", model.material_co2, not_negative);
    return model;
}

}  // namespace bead
