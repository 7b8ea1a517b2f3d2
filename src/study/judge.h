// What a stream of commands costs on a machine: time, motion, motors' features, energy. The same
// judge hears our own plans and anybody's G-code.
//
//     Judge judge(machine);
//     read_gcode(file, [&](const Command& command) { judge.add(command); });
//     const Assessment cost = judge.finish();
#pragma once
#include <optional>

#include "energy/meter.h"
#include "energy/published.h"
#include "machine/material.h"
#include "machine/printer.h"
#include "motion/planner.h"
#include "motion/totals.h"

namespace bead {

struct Machine {
    Printer printer;
    Material material;
    PlannerOptions motion;
};

struct Assessment {
    EnergyReport energy;  // all 0 if nobody asked for it
    MotionTotals motion;
    Features features;
};

enum class Judging { motion, motion_and_energy };

class Judge {
  public:
    // `watch` is told every event too.
    explicit Judge(const Machine& machine, MotionSink watch = {},
                   Judging judging = Judging::motion_and_energy);
    Judge(const Judge&) = delete;  // the planner reports to this very object
    Judge& operator=(const Judge&) = delete;

    void add(const Command& command) {
        planner_->add(command);
        if (meter_) follow(command);
    }
    // Energy over time is told too, see EnergyMeter::listen; expects that energy is asked for.
    void listen(PowerListener listener) { meter_.value().listen(std::move(listener)); }
    Assessment finish();
    [[nodiscard]] const Limits& limits() const { return planner_->limits(); }

  private:
    void hear(const MotionEvent& event);
    void follow(const Command& command);

    bool moved_ = false;
    std::optional<EnergyMeter> meter_;
    MotionTotals totals_;
    Features features_;
    MotionSink watch_;
    std::unique_ptr<Planner> planner_;
};

}  // namespace bead
