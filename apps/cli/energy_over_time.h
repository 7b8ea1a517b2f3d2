// What `beadwork energy` tells of energy over time: the power curve as a table and as a picture,
// and what it costs by a tariff.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/output_file.h"
#include "energy/power_curve.h"
#include "energy/tariff.h"
#include "energy_mode.h"
#include "motion/block.h"

namespace bead::cli {

struct OverTimeOptions {
    EnergyMode mode = EnergyMode::physics;
    std::string csv, picture;  // files; empty: none
    double step = 1;           // s
    std::optional<Tariff> tariff;
    double start = 0;  // time of day, s
};

class EnergyOverTime {
  public:
    explicit EnergyOverTime(const OverTimeOptions& options);
    EnergyOverTime(const EnergyOverTime&) = delete;
    EnergyOverTime& operator=(const EnergyOverTime&) = delete;

    [[nodiscard]] bool is_asked_for() const { return curve_ || billing_; }
    PowerListener listener();
    // Of the published modes, which know motion only: waits for heaters take no time there.
    void add_motion(const MotionEvent& event);
    void finish(const std::string& title);

    [[nodiscard]] std::optional<Bill> bill() const;

  private:
    void hear(const PowerPiece& piece);
    void write(const PowerStep& step);
    void write_picture(const std::string& title) const;
    [[nodiscard]] double next_cut(double time) const;

    OverTimeOptions options_;
    std::optional<OutputFile> csv_;
    std::optional<PowerCurve> curve_;
    std::optional<Billing> billing_;
    std::vector<Energy> steps_;  // W, for the picture
    double motion_time_ = 0;     // s
};

}  // namespace bead::cli
