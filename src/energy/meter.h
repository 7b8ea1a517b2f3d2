// The physics model: what the whole machine draws while it heats up and prints, by consumer, layer
// and role (docs/energy.md has the formulas and what is still left out).
//
//     EnergyMeter meter(printer, material);
//     simulate(commands, …, [&](const MotionEvent& event) { meter.add(event); });
//     const EnergyReport report = meter.report();
#pragma once
#include <array>
#include <vector>

#include "energy/delta_motors.h"
#include "energy/heated_body.h"
#include "energy/motors.h"
#include "machine/material.h"
#include "machine/printer.h"
#include "motion/block.h"

namespace bead {

// At the wall (supply losses included), in J.
struct Energy {
    double bed = 0, hotend = 0, motors = 0, fans = 0, electronics = 0;
};
Energy operator+(const Energy& a, const Energy& b);
Energy operator-(const Energy& a, const Energy& b);
double total(const Energy& energy);

// All that is done from one LayerStart to the next, waits for a heater not included.
struct LayerEnergy {
    double z = 0;         // mm, top of the layer
    double duration = 0;  // s
    double total = 0;     // J
};

// Nothing is lost and nothing counted twice:
//     total(energy) = sum of by_role = heat_up + before_layers + sum of by_layer
struct EnergyReport {
    Energy energy;                // heat-up included
    double heat_up = 0;           // J, of it while waiting for a heater
    double heat_up_duration = 0;  // s
    double before_layers = 0;     // J, of it before the first layer, waits apart
    double duration = 0;          // s, of all but the waits
    double xy_motors = 0;         // J, of it the motors that move X and Y, standing included
    double peak_power = 0;        // W, at the wall, pulses of heaters averaged out
    double co2 = 0;               // g
    std::vector<LayerEnergy> by_layer;
    PerRole<double> by_role{};  // J; waits and dwells are Role::other
};

// Each event is taken in constant time; memory grows only with the number of layers.
class EnergyMeter {
  public:
    // Expects a positive supply efficiency, motors with positive efficiency and, of each heater
    // that can draw anything, a positive capacity and resistance.
    EnergyMeter(const Printer& printer, const Material& material);
    // A cartesian machine of that power; the filament's diameter in mm.
    EnergyMeter(const PowerModel& power, const Material& material, double filament_diameter);
    void add(const MotionEvent& event);
    // Where the head of a delta stands now, mm; at first over the middle. `add` follows it from
    // there, and throws Error for a block beyond the reach of the arms. Other kinematics do not
    // care.
    void place(Vec2 head) { head_ = head; }
    [[nodiscard]] Vec2 place() const { return head_; }
    [[nodiscard]] EnergyReport report() const;

  private:
    // A stretch of time in which nothing changes but the place of the axes.
    struct Stretch {
        double duration = 0;  // s
        MotorDraw motors{};   // above standing
        double melt = 0;      // g
        Role role = Role::other;
        bool heating = false;
    };

    void take(const Block& block);
    void take(const Dwell& dwell);
    void take(const SetHeat& heat);
    void take(const SetFan& fan);
    void take(const LayerStart& layer);

    MotorDraw motors_of(const Block& block);
    void pass(const Stretch& stretch);
    void book(const Stretch& stretch, const Energy& energy);
    double melted(double filament);  // g
    [[nodiscard]] double hotend_conductance() const;
    [[nodiscard]] double bed_conductance() const;
    [[nodiscard]] double fan_power() const;

    PowerModel power_;
    Material material_;
    Kinematics kinematics_;
    Delta delta_;
    Vec2 head_;
    double grams_per_mm_;     // of filament
    double standing_ = 0;     // W, all motors
    double standing_xy_ = 0;  // W
    double wall_, bed_wall_;  // W at the wall per W drawn
    HeatedBody hotend_, bed_;
    double fan_duty_ = 0;
    double retracted_ = 0;  // mm of filament
    EnergyReport sum_;
};

}  // namespace bead
