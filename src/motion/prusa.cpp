#include "motion/prusa.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/expects.h"
#include "motion/jerk.h"
#include "motion/limit_changes.h"
#include "motion/obey.h"
#include "motion/slowdown.h"

namespace bead {
namespace {

constexpr double least_prusa_feed = 0.05;  // mm/s; slower is taken as this
constexpr double prusa_halt_preference =
    0.99;                          // a halt is taken when it is at most 1 % slower than coasting
constexpr double standing = 1e-4;  // mm/s, below this the machine stands

// Of a number that is not below 0; std::ceil is a call where the processor's own may be missing.
double rounded_up(double x) {
    const auto whole = static_cast<double>(static_cast<std::int64_t>(x));
    return whole < x ? whole + 1 : whole;
}

LookAheadRules rules_of(const PrusaOptions& options) {
    return {.depth = options.lookahead,
            .bounded_halts = !options.quirks.unbounded_halt,
            .late_raise = options.quirks.late_raise,
            .at_most_stays = options.quirks.at_most_stays};
}

}  // namespace

PrusaPlanner::PrusaPlanner(const Limits& limits, const PrusaOptions& options, MotionSink sink)
    : limits_(limits),
      quirks_(options.quirks),
      arcs_(options.arcs),
      queue_(rules_of(options), std::move(sink)) {
    BEAD_EXPECTS(options.lookahead == 0 || options.lookahead >= 4);
    for (std::size_t i = 0; i < mm_per_step_.size(); ++i)
        mm_per_step_[i] = 1 / limits.steps_per_mm[i];
}

void PrusaPlanner::add(const Command& command) { obey(*this, command); }

void PrusaPlanner::set_position(const SetPosition& position) {
    const bool head = position.to[axis_x] || position.to[axis_y] || position.to[axis_z];
    const bool waits =
        quirks_.any_e_drains ? head || position.to[axis_e].value_or(0) != 0 : !position.to[axis_e];
    if (waits) drain();
    if (head) previous_ = {};
    for (const Axis i : {axis_x, axis_y, axis_z, axis_e}) {
        if (!position.to[i]) continue;
        place_[i] = *position.to[i];
        frame_.set(i, place_[i], limits_);
    }
}

void PrusaPlanner::home(const Home& home) {
    for (const Axis i : {axis_x, axis_y, axis_z}) {
        if (!home.axes[i]) continue;
        place_[i] = 0;
        frame_.home(i);
    }
}

void PrusaPlanner::change(const SetLimits& limits) { limits_ = changed(limits_, limits); }

void PrusaPlanner::drain() {
    queue_.drain();
    since_drain_ = 0;
}

void PrusaPlanner::arc(const Arc& arc, std::int64_t line) {
    each_chord(arc, place_, {arcs_, limits_.arc_resolution},
               [&](const Move& chord) { move(chord, line); });
}

void PrusaPlanner::move(const Move& move, std::int64_t line) {
    place_ = move.to;
    StepMove taken;
    if (!frame_.take(move.to, limits_, taken)) return;
    queue_.make_room();
    Block& block = queue_.block();
    block.line = line;
    block.role = move.role;
    block.bead = move.bead;
    PerAxis<double> speed;
    measure(move, taken, block, speed);
    block.acceleration = path_acceleration(taken, block);
    queue_.push(enter(block, speed));
}

// Way, length and speeds, all brought down together so that no axis exceeds its own.
void PrusaPlanner::measure(const Move& move, const StepMove& taken, Block& block,
                           PerAxis<double>& speed) const {
    PerAxis<double>& delta = block.delta;
    for (std::size_t i = 0; i < delta.size(); ++i)
        delta[i] = static_cast<double>(taken.steps[i]) * mm_per_step_[i];
    block.length = taken.filament ? std::abs(delta[axis_e])
                                  : length(Vec3{delta[axis_x], delta[axis_y], delta[axis_z]});
    double feed = std::max(move.feed, least_prusa_feed);
    if (limits_.slowdown) feed = slowed_feed(feed, block.length, queue_.size());
    const double per_mm = feed / block.length;
    double scale = 1;
    for (std::size_t i = 0; i < speed.size(); ++i) {
        speed[i] = per_mm * delta[i];
        if (std::abs(speed[i]) > limits_.max_feedrate[i])
            scale = std::min(scale, limits_.max_feedrate[i] / std::abs(speed[i]));
    }
    for (double& v : speed) v *= scale;
    block.v_nominal = feed * scale;
}

double PrusaPlanner::path_acceleration(const StepMove& taken, const Block& block) const {
    const bool travels = taken.steps[axis_e] == 0 && quirks_.travel_acceleration;
    const double asked = !taken.head ? limits_.retract_acceleration
                         : travels   ? limits_.travel_acceleration
                                     : limits_.acceleration;
    if (!quirks_.crude_axis_cap) {
        double capped = asked;
        for (std::size_t i = 0; i < taken.steps.size() && taken.head; ++i)
            if (taken.steps[i] != 0)
                capped = std::min(
                    capped, limits_.max_acceleration[i] * block.length / std::abs(block.delta[i]));
        return capped;
    }
    const auto most = static_cast<double>(taken.longest);
    const double steps_per_mm = most / block.length;
    double rate = rounded_up(asked * steps_per_mm);
    for (const Axis i : {axis_x, axis_y, axis_e, axis_z}) {
        const double axis_most = limits_.max_acceleration[i] * limits_.steps_per_mm[i];
        const auto axis_steps = static_cast<double>(std::abs(taken.steps[i]));
        if (taken.head && rate * axis_steps > axis_most * most) rate = axis_most;
    }
    return rate / steps_per_mm;
}

double PrusaPlanner::safe_speed(double nominal, const PerAxis<double>& speed) const {
    double safe = nominal;
    bool limited = false;
    for (std::size_t i = 0; i < speed.size(); ++i) {
        const double v = std::abs(speed[i]);
        if (v <= limits_.jerk[i]) continue;
        const bool first = quirks_.crude_safe_speed && !limited;
        safe = first ? limits_.jerk[i] : std::min(safe, nominal * limits_.jerk[i] / v);
        limited = true;
    }
    return safe;
}

// Path speed at which every axis' step stays within its jerk, both blocks having slowed to it.
double PrusaPlanner::junction_speed(double nominal, const PerAxis<double>& speed) const {
    const double common = std::min(nominal, previous_.nominal);
    const double before = common / previous_.nominal;
    const double after = quirks_.unscaled_entry ? 1.0 : common / nominal;
    return common * jerk_factor(previous_.speed, before, speed, after, limits_.jerk);
}

Junction PrusaPlanner::enter(const Block& block, const PerAxis<double>& speed) {
    const double safe = safe_speed(block.v_nominal, speed);
    const std::int64_t needed = quirks_.second_block_halts ? 2 : 1;
    bool halt = since_drain_ < needed || previous_.nominal <= standing;
    double entry = safe;
    if (!halt) {
        const double junction = junction_speed(block.v_nominal, speed);
        const double threshold = prusa_halt_preference * junction;
        halt = previous_.safe > threshold && safe > threshold;
        if (!halt) entry = junction;
    }
    const double brake = safe * safe + 2 * block.acceleration * block.length;  // squared
    previous_ = {speed, block.v_nominal, safe};
    ++since_drain_;
    return {.max_entry = entry * entry,
            .entry = std::min(entry * entry, brake),
            .last_exit = safe * safe,
            .halt = halt,
            .apart = halt && !quirks_.shared_halt_speed,
            .at_nominal = quirks_.nominal_shortcut && block.v_nominal * block.v_nominal <= brake};
}

}  // namespace bead
