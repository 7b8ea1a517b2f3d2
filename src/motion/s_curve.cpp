#include "motion/s_curve.h"

#include <algorithm>
#include <cmath>

#include "geom/vec.h"
#include "motion/arc_chords.h"
#include "motion/jerk_limited.h"
#include "motion/limit_changes.h"
#include "motion/obey.h"

namespace bead {
namespace {

constexpr std::size_t usual_window = 2048;  // moves
constexpr double least_way = 1e-9;          // mm, below this nothing moves
constexpr double least_asked_feed = 0.05;   // mm/s; slower is taken as this

enum class Trend { up, level, down };
Trend trend_of(const JerkPhase& phase) {
    const double slope = phase.a != 0 ? phase.a : phase.j;
    return slope > 0 ? Trend::up : slope < 0 ? Trend::down : Trend::level;
}

// What a block takes of the phases from `phase` on; leaves `phase` at the one that its end is in.
void shape(Block& block, const SpeedPlan& plan, std::size_t k, std::size_t& phase) {
    const double start = plan.time[k], end = plan.time[k + 1];
    block.v_entry = plan.speed[k];
    block.v_exit = plan.speed[k + 1];
    block.v_peak = std::max(block.v_entry, block.v_exit);
    block.t_accel = block.t_cruise = block.t_decel = 0;
    for (;; ++phase) {
        const JerkPhase& p = plan.phases[phase];
        if (p.t > start && p.t < end) block.v_peak = std::max(block.v_peak, p.v);
        const bool last = phase + 1 == plan.phases.size();
        const double until = last ? end : std::min(end, plan.phases[phase + 1].t);
        const double t = std::max(0.0, until - std::max(start, p.t));
        (trend_of(p) == Trend::up     ? block.t_accel
         : trend_of(p) == Trend::down ? block.t_decel
                                      : block.t_cruise) += t;
        if (last || plan.phases[phase + 1].t >= end) return;
    }
}

}  // namespace

SCurvePlanner::SCurvePlanner(const Limits& limits, MotionSink sink)
    : limits_(limits), sink_(std::move(sink)), full_(usual_window) {}

void SCurvePlanner::add(const Command& command) { obey(*this, command); }

void SCurvePlanner::pass(const MotionEvent& event) {
    if (window_.empty())
        sink_(event);
    else
        between_.push_back(event);
}

void SCurvePlanner::set_position(const SetPosition& position) {
    for (std::size_t i = 0; i < place_.size(); ++i) place_[i] = position.to[i].value_or(place_[i]);
}

void SCurvePlanner::home(const Home& home) {
    for (std::size_t i = 0; i < home.axes.size(); ++i)
        if (home.axes[i]) place_[i] = 0;
}

void SCurvePlanner::change(const SetLimits& limits) { limits_ = changed(limits_, limits); }

void SCurvePlanner::arc(const Arc& arc, std::int64_t line) {
    each_chord(arc, place_, {ArcStyle::klipper, limits_.arc_resolution},
               [&](const Move& chord) { move(chord, line); });
}

void SCurvePlanner::move(const Move& move, std::int64_t line) {
    Queued queued;
    measure(move, queued);
    place_ = move.to;
    if (queued.block().length < least_way) return;
    queued.block().line = line;
    queued.block().role = move.role;
    queued.block().bead = move.bead;
    queued.between = between_.size();
    if (!window_.empty()) queued.max_entry = corner(window_.back(), queued);
    window_.push_back(queued);
    if (window_.size() >= full_) release(false);
}

void SCurvePlanner::measure(const Move& move, Queued& queued) const {
    Block& block = queued.block();
    for (std::size_t i = 0; i < place_.size(); ++i) block.delta[i] = move.to[i] - place_[i];
    const PerAxis<double>& delta = block.delta;
    block.length = length(Vec3{delta[axis_x], delta[axis_y], delta[axis_z]});
    queued.head = block.length >= least_way;
    if (!queued.head) {
        block.delta = {0, 0, 0, delta[axis_e]};
        block.length = std::abs(delta[axis_e]);
        if (block.length < least_way) return;
    }
    block.v_nominal = std::max(move.feed, least_asked_feed);
    block.acceleration = !queued.head         ? limits_.retract_acceleration
                         : delta[axis_e] != 0 ? limits_.acceleration
                                              : limits_.travel_acceleration;
    for (std::size_t i = 0; i < delta.size(); ++i) {
        const double share = std::abs(delta[i]) / block.length;
        queued.leg.direction[i] = delta[i] / block.length;
        if (share == 0) continue;
        block.v_nominal = std::min(block.v_nominal, limits_.max_feedrate[i] / share);
        block.acceleration = std::min(block.acceleration, limits_.max_acceleration[i] / share);
    }
    queued.leg.length = block.length;
    queued.leg.acceleration = block.acceleration;
    queued.leg.deviation = corner_deviation(limits_.square_corner_velocity, block.acceleration);
}

double SCurvePlanner::corner(const Queued& before, const Queued& after) const {
    if (!before.head || !after.head) return 0;
    return std::sqrt(std::min(
        corner_speed2(before.leg, after.leg),
        filament_corner_speed2(before.leg, after.leg, limits_.instantaneous_corner_velocity)));
}

// Plans the window and lets its first part go: all, or up to a place of no acceleration about its
// middle, from where the next window goes on.
void SCurvePlanner::release(bool all) {
    SpeedLimits limits;
    limits.jerk = limits_.path_jerk;
    for (Queued& queued : window_) {
        const Block& block = queued.block();
        limits.length.push_back(block.length);
        limits.speed.push_back(block.v_nominal);
        limits.acceleration.push_back(block.acceleration);
        limits.point.push_back(queued.max_entry);
    }
    limits.point.front() = entry_;
    limits.point.push_back(0);
    const SpeedPlan plan = jerk_limited(limits);

    std::size_t count = window_.size();
    if (!all) {
        count /= 2;
        while (count > 0 && !plan.steady[count]) --count;
        full_ = count > 0 ? usual_window : 2 * full_;
    }
    std::size_t phase = 0;
    for (std::size_t k = 0; k < count; ++k) shape(window_[k].block(), plan, k, phase);
    entry_ = all ? 0 : plan.speed[count];
    tell(count);
}

void SCurvePlanner::tell(std::size_t count) {
    std::size_t told = 0;
    for (std::size_t k = 0; k < count; ++k) {
        for (; told < window_[k].between; ++told) sink_(between_[told]);
        sink_(window_[k].event);
    }
    const auto gone = [](auto& list, std::size_t n) {
        list.erase(list.begin(), list.begin() + std::ptrdiff_t(n));
    };
    gone(window_, count);
    gone(between_, told);
    for (Queued& queued : window_) queued.between -= told;
}

void SCurvePlanner::drain() {
    if (!window_.empty()) release(true);
    for (const MotionEvent& event : between_) sink_(event);
    between_.clear();
    full_ = usual_window;
}

}  // namespace bead
