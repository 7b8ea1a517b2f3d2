#include "energy_over_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "energy/block_part.h"
#include "energy/published.h"
#include "scene/stacked_areas.h"

namespace bead::cli {
namespace {

constexpr std::string_view physics_head =
    "time_s,power_w,bed_w,hotend_w,motors_w,fans_w,electronics_w,mode\n";
constexpr std::string_view motors_head = "time_s,power_w,motors_w,mode\n";

struct Ink {
    std::string_view name, ink;
    double Energy::*joules;
};
constexpr std::array inks{
    Ink{"electronics", "#8e8e8e", &Energy::electronics},
    Ink{"fans", "#8674a0", &Energy::fans},
    Ink{"motors", "#5790bf", &Energy::motors},
    Ink{"hot end", "#c75c3b", &Energy::hotend},
    Ink{"bed", "#ecab6d", &Energy::bed},
};

// Means of `many` steps each.
std::vector<Energy> joined(const std::vector<Energy>& steps, std::size_t many) {
    std::vector<Energy> means((steps.size() + many - 1) / many);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::size_t group = i / many;
        const std::size_t members = std::min(many, steps.size() - group * many);
        means[group] += 1.0 / static_cast<double>(members) * steps[i];
    }
    return means;
}

}  // namespace

EnergyOverTime::EnergyOverTime(const OverTimeOptions& options) : options_(options) {
    if (!options.csv.empty()) {
        csv_.emplace(options.csv);
        csv_->stream() << (options.mode == EnergyMode::physics ? physics_head : motors_head);
    }
    if (!options.csv.empty() || !options.picture.empty())
        curve_.emplace(options.step, [this](const PowerStep& step) { write(step); });
    if (options.tariff) billing_.emplace(*options.tariff, options.start);
}

PowerListener EnergyOverTime::listener() {
    if (!is_asked_for() || options_.mode != EnergyMode::physics) return {};
    return {[this](double time) { return next_cut(time); },
            [this](const PowerPiece& piece) { hear(piece); }};
}

double EnergyOverTime::next_cut(double time) const {
    constexpr double never = std::numeric_limits<double>::infinity();
    return std::min(curve_ ? curve_->end_of_step(time) : never,
                    billing_ ? billing_->next_change(time) : never);
}

void EnergyOverTime::hear(const PowerPiece& piece) {
    if (curve_) curve_->add(piece);
    if (billing_) billing_->add(piece);
}

void EnergyOverTime::add_motion(const MotionEvent& event) {
    if (const Dwell* dwell = std::get_if<Dwell>(&event)) motion_time_ += dwell->duration;
    const Block* block = std::get_if<Block>(&event);
    if (block == nullptr) return;
    const double seconds = duration(*block);
    for (double from = 0; from < seconds;) {
        const double to = std::min(seconds, next_cut(motion_time_ + from) - motion_time_);
        const Features f = features_of(part_of(*block, from, to));
        const double joules =
            options_.mode == EnergyMode::published ? published_energy(f) : standing_form(f);
        hear({motion_time_ + from, to - from, false, {.motors = joules}});
        from = to;
    }
    motion_time_ += seconds;
}

void EnergyOverTime::write(const PowerStep& step) {
    const Energy& p = step.power;
    if (!options_.picture.empty()) steps_.push_back(p);
    if (!csv_) return;
    if (options_.mode == EnergyMode::physics)
        csv_->stream() << fmt::format("{:.10g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{}\n",
                                      step.time, total(p), p.bed, p.hotend, p.motors, p.fans,
                                      p.electronics, name_of(options_.mode));
    else
        csv_->stream() << fmt::format("{:.10g},{:.9g},{:.9g},{}\n", step.time, p.motors, p.motors,
                                      name_of(options_.mode));
}

void EnergyOverTime::finish(const std::string& title) {
    if (curve_) curve_->finish();
    if (csv_) csv_->keep();
    if (!options_.picture.empty() && !steps_.empty()) write_picture(title);
}

void EnergyOverTime::write_picture(const std::string& title) const {
    constexpr std::size_t columns = 450;
    const std::size_t many = (steps_.size() + columns - 1) / columns;
    const std::vector<Energy> means = joined(steps_, many);
    const double step = options_.step * static_cast<double>(many);
    StackedAreas areas;
    areas.title = title;
    areas.caption = fmt::format("mode {}: {}; means of {:g} s", name_of(options_.mode),
                                about(options_.mode), step);
    areas.unit = "W";
    areas.step = step;
    for (const Ink& ink : inks) {
        if (options_.mode != EnergyMode::physics && ink.joules != &Energy::motors) continue;
        Band band{ink.name, ink.ink, {}};
        for (const Energy& power : means) band.values.push_back(power.*ink.joules);
        areas.bands.push_back(std::move(band));
    }
    OutputFile file(options_.picture);
    file.stream() << stacked_areas_svg(areas);
    file.keep();
}

std::optional<Bill> EnergyOverTime::bill() const {
    if (!billing_) return {};
    return billing_->bill();
}

}  // namespace bead::cli
