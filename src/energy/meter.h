// The physics model: what the whole machine draws while it heats up and prints, by consumer, layer
// and role (docs/energy.md has the formulas and what is still left out).
//
//     EnergyMeter meter(printer, material);
//     simulate(commands, …, [&](const MotionEvent& event) { meter.add(event); });
//     const EnergyReport report = meter.report();
#pragma once
#include "energy/delta_motors.h"
#include "energy/heated_body.h"
#include "energy/power_pieces.h"
#include "energy/report.h"
#include "energy/standstill.h"
#include "machine/material.h"
#include "machine/printer.h"
#include "motion/block.h"

namespace bead {

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
    // From now on every piece of time is told too; it makes no difference to the report but for
    // rounding.
    void listen(PowerListener listener) { listener_ = std::move(listener); }
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
    struct Held {
        double energy = 0, peak = 0;  // J, W
    };
    // What the terms of a report are products of.
    struct Sums {
        PerAxis<double> speed{}, work{};  // J
        PerAxis<double> reduced{};        // s with the hold current
        double warm = 0, duty = 0;        // s: hot end's fan running; part fan, times its duty
        double hotend = 0, blown = 0;     // K s above ambient; the same, times the fan's duty
        double plastic = 0;               // K g of plastic warmed
        double molten = 0;                // g
        double bed = 0;                   // K s above ambient
    };
    struct Layer {
        double z = 0, duration = 0;
        PerRole<Energy> by_role{};
    };

    void take(const Block& block);
    void take(const Dwell& dwell);
    void take(const SetHeat& heat);
    void take(const SetFan& fan);
    void take(const LayerStart& layer);

    template <class Part>
    void in_pieces(double seconds, const Part& part);
    MotorDraw motors_of(const Block& block);
    void pass(const Stretch& stretch);
    Held held(const Stretch& stretch);
    void count(const Stretch& stretch, double hotend, double bed);
    void book(const Stretch& stretch, const Energy& energy);
    double melted(double filament);  // g
    void load_bed(double grams);
    [[nodiscard]] double hotend_conductance() const;
    [[nodiscard]] double bed_conductance() const;
    [[nodiscard]] double fan_power() const;
    [[nodiscard]] EnergyTerms terms() const;
    [[nodiscard]] double elapsed() const { return heat_up_duration_ + duration_; }

    PowerModel power_;
    Material material_;
    Kinematics kinematics_;
    Delta delta_;
    Vec2 head_;
    double grams_per_mm_;     // of filament
    double standing_ = 0;     // W, all motors
    double wall_, bed_wall_;  // W at the wall per W drawn
    HeatedBody hotend_, bed_;
    Standstill standstill_;
    double fan_duty_ = 0;
    double retracted_ = 0;  // mm of filament
    PowerListener listener_;

    Sums sums_;
    Energy heat_up_;
    double heat_up_duration_ = 0, duration_ = 0;
    double peak_power_ = 0, peak_time_ = 0;
    Layer before_;
    std::vector<Layer> layers_;
};

}  // namespace bead
