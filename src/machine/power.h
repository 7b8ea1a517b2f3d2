// What draws power in a printer. Electrical values are on the low-voltage side unless they say
// otherwise; the supply's losses come on top. SI units; temperatures in °C.
#pragma once
#include <array>
#include <cstddef>
#include <optional>

namespace bead {

// One per slot (machine/kinematics.h). What is a motor's follows the motor; friction and mass are
// the axis' of the slot's name, whoever pulls it, but on a delta each carriage's own.
struct Motor {
    double standing = 0;     // W, winding loss with its run current, moving or not
    double holding = -1;     // W, the same with its hold current; below 0: as `standing`
    double resistance = 0;   // ohm of one winding, so that standing = 2 R I² (rms); 0: not known
    double per_speed = 0;    // W per mm/s of the motor's belt (iron loss, viscous friction)
    double friction = 0;     // N, constant friction of the rails
    double moving_mass = 0;  // kg, all that moves along the axis, rotors included
    double efficiency = 1;   // mechanical, from electrical input above standing to motion
};

// W, at rest for long.
constexpr double holding(const Motor& motor) {
    return motor.holding < 0 ? motor.standing : motor.holding;
}

struct HotEnd {
    double heater = 0;            // W, most it can draw
    double capacity = 0;          // J/K
    double resistance_still = 0;  // K/W to ambient, fan off
    double resistance_blown = 0;  // K/W to ambient, fan full
};

struct BedHeater {
    double heater = 0;      // W, most it can draw
    double capacity = 0;    // J/K
    double resistance = 0;  // K/W to ambient
    bool mains = false;     // fed past the supply, without its losses
};

// How far the numbers of a consumer may be off: standard uncertainty as a fraction of its energy.
struct PowerUncertainty {
    double bed = 0, hotend = 0, motors = 0, fans = 0, electronics = 0;
    double supply = 0;  // of the efficiency, common to all that the supply feeds
};

struct PowerModel {
    double electronics = 0;        // W: board, display, sensors; always
    double part_fan = 0;           // W at full duty
    double hotend_fan = 0;         // W, runs while the hot end is warm
    double supply_efficiency = 1;  // low-voltage power / wall power
    double ambient = 25;           // °C
    double grid_co2 = 0;           // g per kWh of wall energy
    std::array<Motor, 4> motors;   // X, Y, Z (all its motors together), E
    double standstill_delay = 0;   // s at rest, after which a driver turns to its hold current
    std::optional<std::size_t> bed_axis;  // which moves the bed, and with it what is printed
    HotEnd hotend;
    BedHeater bed;
    PowerUncertainty uncertainty;
};

}  // namespace bead
