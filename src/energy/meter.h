// The physics model: what the whole machine draws while it heats up and prints, by consumer, layer and
// role (docs/energy.md has the formulas and what is still left out).
//
//     EnergyMeter meter(printer.power, material, printer.filament);
//     simulate(commands, …, [&](const MotionEvent& event) { meter.add(event); });
//     const EnergyReport report = meter.report();
#pragma once
#include <array>
#include <vector>

#include "machine/material.h"
#include "machine/power.h"
#include "motion/block.h"

namespace bead {

// At the wall (supply losses included), in J.
struct Energy {
    double bed = 0, hotend = 0, motors = 0, fans = 0, electronics = 0;
};
Energy operator+(const Energy& a, const Energy& b);
Energy operator-(const Energy& a, const Energy& b);
double total(const Energy& energy);

struct LayerEnergy {
    double z = 0;         // mm, top of the layer
    double duration = 0;  // s
    double total = 0;     // J
};

struct EnergyReport {
    Energy energy;                                    // heat-up included
    double heat_up = 0;                               // J, of it
    double heat_up_duration = 0;                      // s
    double duration = 0;                              // s, of the print after heat-up
    double xy_motors = 0;                             // J, of it the X and Y motors, at the wall
    double peak_power = 0;                            // W
    double co2 = 0;                                   // g
    std::vector<LayerEnergy> by_layer;                // before the first layer: none
    std::array<double, role_names.size()> by_role{};  // J
};

class EnergyMeter {
  public:
    EnergyMeter(const PowerModel& power, const Material& material, double filament_diameter);
    void add(const MotionEvent& event);
    [[nodiscard]] EnergyReport report() const;

  private:
    // yours
};

}  // namespace bead
