#include "job/motor_table.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/error.h"

namespace bead {
namespace {

constexpr Range positive_fraction{.low = 0, .high = 1, .open_low = true};

// Losses of a winding: what the file says of any of the three makes one of currents and resistance.
constexpr std::array currents{"power.motors.run_current_a", "power.motors.hold_current_a",
                              "power.motors.winding_ohm"};
constexpr std::array losses{"power.motors.standing_w", "power.motors.holding_w"};

// Throws for what the file says at the key.
[[noreturn]] void fail(TomlReader& file, std::string_view key, const std::string& what) {
    const std::string place = *file.place_of(key);
    throw Error(fmt::format("{}: {}: {}", place, key, what),
                place.starts_with("--") ? Fault::usage : Fault::input);
}

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
            fail(file, *said(file, currents),
                 fmt::format("the run current is not known; add {} = [A rms of X, Y, Z, E]",
                             currents[0]));
        if (winding[i] <= 0)
            fail(file, *said(file, currents),
                 fmt::format("the winding's resistance is not known; add {} = [ohm of X, Y, Z, E], "
                             "or say {} instead",
                             currents[2], losses[0]));
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
        fail(file, *by_loss,
             fmt::format("the loss is told twice, {} has it too; leave one out", *by_current));
    if (by_current) read_currents(file, motors);
    if (by_loss) read_losses(file, motors);
    for (std::size_t i = 0; i < 4; ++i)
        if (holding(motors[i]) > motors[i].standing * (1 + 1e-9))
            fail(file, by_current ? *by_current : *by_loss,
                 fmt::format("motor {} would draw more at rest than while it runs; hold it with at "
                             "most what it runs with",
                             "XYZE"[i]));
}

}  // namespace

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
        fail(file, "power.motors.bed_axis", "the bed of a delta stands still; write \"none\"");
    return choice - 1;
}

}  // namespace bead
