// Streams of timed motion with all that a print may have, and a machine to meter them on.
#pragma once
#include <vector>

#include "energy/meter.h"
#include "support/blocks.h"

namespace bead::test {

inline const Material plain{.density = 1.25, .heat_capacity = 2, .latent = 10};
inline constexpr double thin = 1.75;  // mm of filament

inline PowerModel desktop() {
    PowerModel power;
    power.electronics = 9;
    power.part_fan = 2;
    power.hotend_fan = 1;
    power.supply_efficiency = 0.8;
    power.grid_co2 = 360;
    power.motors[axis_x] = {.standing = 0.7, .per_speed = 0.05, .friction = 2, .moving_mass = 0.7};
    power.motors[axis_y] = {.standing = 1.0, .per_speed = 0.05, .friction = 3, .moving_mass = 1.0};
    power.motors[axis_z] = {.standing = 2.0, .friction = 12};
    power.motors[axis_e] = {.standing = 2.0, .friction = 30};
    power.hotend = {.heater = 38, .capacity = 12, .resistance_still = 20, .resistance_blown = 10};
    power.bed = {.heater = 150, .capacity = 400, .resistance = 1};
    return power;
}

using Stream = std::vector<MotionEvent>;

inline EnergyReport measured(const Stream& stream, const PowerModel& power = desktop()) {
    EnergyMeter meter(power, plain, thin);
    for (const MotionEvent& event : stream) meter.add(event);
    return meter.report();
}

// A print with all there is: waits, layers, dwells, fan and temperature changes.
inline Stream any_print() {
    Stream stream{SetHeat{Heater::bed, 60, false}, SetHeat{Heater::hotend, 150, false},
                  SetHeat{Heater::bed, 60, true}, SetHeat{Heater::hotend, 215, true}};
    const int blocks = *rc::gen::inRange(1, 60);
    for (int i = 0; i < blocks; ++i) {
        const int kind = *rc::gen::inRange(0, 12);
        if (kind == 0) stream.emplace_back(Dwell{number_between(0, 5)});
        if (kind == 1) stream.emplace_back(SetFan{number_between(0, 1)});
        if (kind == 2) stream.emplace_back(LayerStart{i * 0.2, 0.2});
        if (kind == 3)
            stream.emplace_back(SetHeat{Heater::hotend, number_between(0, 250), i % 2 == 0});
        stream.emplace_back(any_block());
    }
    return stream;
}

inline bool near(double a, double b) { return std::abs(a - b) <= 1e-9 * (1 + std::abs(a)); }

}  // namespace bead::test
