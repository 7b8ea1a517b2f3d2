#include "motion/klipper.h"

#include <algorithm>
#include <cmath>

#include "geom/vec.h"
#include "motion/arc_chords.h"
#include "motion/limit_changes.h"
#include "motion/obey.h"

namespace bead {
namespace {

constexpr double no_way = 1e-9;             // mm, below this nothing moves
constexpr double no_limit = 99999999.9;     // mm/s², filament alone before its own limits
constexpr double look_after = 0.25;         // s of moves between two looks at the queue
constexpr double slowest_feed = 0.05;       // mm/s; slower is taken as this
constexpr double most_cruise_ratio = 0.99;  // all cruise would be no speed at all

double max_velocity(const Limits& limits) {
    return std::max(limits.max_feedrate[axis_x], limits.max_feedrate[axis_y]);
}

// A block from its speeds squared: distances first, times from them.
void shape(Block& block, double start2, double cruise2, double end2) {
    const double per = 0.5 / block.acceleration;
    const double up = (cruise2 - start2) * per, down = (cruise2 - end2) * per;
    block.v_entry = std::sqrt(start2);
    block.v_peak = std::sqrt(cruise2);
    block.v_exit = std::sqrt(end2);
    block.t_accel = up / ((block.v_entry + block.v_peak) * 0.5);
    block.t_cruise = std::max(0.0, block.length - up - down) / block.v_peak;
    block.t_decel = down / ((block.v_exit + block.v_peak) * 0.5);
}

}  // namespace

KlipperPlanner::KlipperPlanner(const Limits& limits, MotionSink sink)
    : limits_(limits), sink_(std::move(sink)), until_flush_(look_after) {}

void KlipperPlanner::add(const Command& command) { obey(*this, command); }

void KlipperPlanner::pass(const MotionEvent& event) {
    if (queue_.empty())
        sink_(event);
    else
        between_.emplace_back(gone_ + queue_.size(), event);
}

void KlipperPlanner::set_position(const SetPosition& position) {
    for (std::size_t i = 0; i < place_.size(); ++i) place_[i] = position.to[i].value_or(place_[i]);
}

void KlipperPlanner::home(const Home& home) {
    for (std::size_t i = 0; i < home.axes.size(); ++i)
        if (home.axes[i]) place_[i] = 0;
}

// M204 gives one acceleration: S, or the smaller of P and T.
void KlipperPlanner::change(const SetLimits& told) {
    SetLimits obeyed;
    obeyed.max_velocity = told.max_velocity;
    obeyed.square_corner_velocity = told.square_corner_velocity;
    obeyed.minimum_cruise_ratio = told.minimum_cruise_ratio;
    obeyed.acceleration = told.max_acceleration_head;
    if (told.acceleration && told.travel_acceleration)
        obeyed.acceleration = std::min(*told.acceleration, *told.travel_acceleration);
    limits_ = changed(limits_, obeyed);
}

void KlipperPlanner::arc(const Arc& arc, std::int64_t line) {
    each_chord(arc, place_, {ArcStyle::klipper, limits_.arc_resolution},
               [&](const Move& chord) { move(chord, line); });
}

void KlipperPlanner::move(const Move& move, std::int64_t line) {
    Queued queued;
    Block& block = queued.block();
    for (std::size_t i = 0; i < place_.size(); ++i) block.delta[i] = move.to[i] - place_[i];
    place_ = move.to;
    block.line = line;
    block.role = move.role;
    block.bead = move.bead;
    block.length = length(Vec3{block.delta[axis_x], block.delta[axis_y], block.delta[axis_z]});
    block.acceleration = limits_.acceleration;
    queued.head = block.length >= no_way;
    const double feed = std::max(move.feed, slowest_feed);
    double speed = std::min(feed, max_velocity(limits_));
    if (!queued.head) {
        for (const Axis i : {axis_x, axis_y, axis_z}) block.delta[i] = 0;
        block.length = std::abs(block.delta[axis_e]);
        if (block.length == 0) return;
        block.acceleration = no_limit;
        speed = feed;
    }
    for (std::size_t i = 0; i < place_.size(); ++i)
        queued.leg.direction[i] = block.delta[i] / block.length;
    queued.max_cruise = speed * speed;
    queued.delta = 2 * block.length * block.acceleration;
    queued.smoothed_delta = 2 * block.length * limits_.acceleration *
                            (1 - std::min(limits_.minimum_cruise_ratio, most_cruise_ratio));

    if (queued.head && block.delta[axis_z] != 0) {
        const double ratio = block.length / std::abs(block.delta[axis_z]);
        limit(queued, limits_.max_feedrate[axis_z] * ratio,
              limits_.max_acceleration[axis_z] * ratio);
    }
    const double filament = queued.leg.direction[axis_e];
    const bool across = block.delta[axis_x] != 0 || block.delta[axis_y] != 0;
    if (filament != 0 && (!across || filament < 0)) {
        const double ratio = 1 / std::abs(filament);
        limit(queued, limits_.extrude_only_velocity * ratio,
              limits_.extrude_only_acceleration * ratio);
    }
    block.v_nominal = std::sqrt(queued.max_cruise);
    queued.leg.length = block.length;
    queued.leg.acceleration = block.acceleration;
    queued.leg.deviation = corner_deviation(limits_.square_corner_velocity, limits_.acceleration);

    queue_.push_back(queued);
    if (queue_.size() == 1) return;
    join(queue_[queue_.size() - 2], queue_.back());
    until_flush_ -= queue_.back().block().length / queue_.back().block().v_nominal;
    if (until_flush_ <= 0) flush(false);
}

void KlipperPlanner::limit(Queued& queued, double speed, double acceleration) const {
    Block& block = queued.block();
    queued.max_cruise = std::min(queued.max_cruise, speed * speed);
    block.acceleration = std::min(block.acceleration, acceleration);
    queued.delta = 2 * block.length * block.acceleration;
    queued.smoothed_delta = std::min(queued.smoothed_delta, queued.delta);
}

void KlipperPlanner::join(const Queued& before, Queued& queued) const {
    if (!before.head || !queued.head) return;
    queued.max_start = std::min(
        {corner_speed2(before.leg, queued.leg),
         filament_corner_speed2(before.leg, queued.leg, limits_.instantaneous_corner_velocity),
         queued.max_cruise, before.max_cruise, before.max_start + before.delta});
    queued.max_smoothed_start =
        std::min(queued.max_start, before.max_smoothed_start + before.smoothed_delta);
}

// From the last move back, as if the machine came to rest there. `all`: it does, and everything
// goes; else only what stands before the last peak of the smoothed plan, which nothing that follows
// can change.
void KlipperPlanner::flush(bool all) {
    struct Delayed {
        std::size_t k;
        double start, end;
    };
    until_flush_ = look_after;
    bool searching = !all;
    std::size_t count = queue_.size();
    std::vector<Delayed> delayed;
    double next_end = 0, next_smoothed = 0, peak = 0;
    for (std::size_t k = queue_.size(); k-- > 0;) {
        Queued& move = queue_[k];
        const double reachable = next_end + move.delta;
        const double start = std::min(move.max_start, reachable);
        const double reachable_smoothed = next_smoothed + move.smoothed_delta;
        const double smoothed = std::min(move.max_smoothed_start, reachable_smoothed);
        if (smoothed < reachable_smoothed) {  // it may speed up
            if (smoothed + move.smoothed_delta > next_smoothed || !delayed.empty()) {
                if (searching && peak > 0) {
                    count = k;
                    searching = false;
                }
                peak = std::min(move.max_cruise, (smoothed + reachable_smoothed) * 0.5);
                if (!searching && k < count) {
                    double cruise = peak;
                    for (auto d = delayed.rbegin(); d != delayed.rend(); ++d) {
                        cruise = std::min(cruise, d->start);
                        shape(queue_[d->k].block(), std::min(d->start, cruise), cruise,
                              std::min(d->end, cruise));
                    }
                }
                delayed.clear();
            }
            if (!searching && k < count) {
                const double cruise = std::min({(start + reachable) * 0.5, move.max_cruise, peak});
                shape(move.block(), std::min(start, cruise), cruise, std::min(next_end, cruise));
            }
        } else {  // its cruise speed depends on the peak before it
            delayed.push_back({k, start, next_end});
        }
        next_end = start;
        next_smoothed = smoothed;
    }
    if (!searching) release(count);
}

void KlipperPlanner::release(std::size_t count) {
    for (; count > 0; --count) {
        while (!between_.empty() && between_.front().first <= gone_) {
            sink_(between_.front().second);
            between_.pop_front();
        }
        sink_(queue_.front().event);
        queue_.pop_front();
        ++gone_;
    }
}

void KlipperPlanner::drain() {
    flush(true);
    for (const auto& [block, event] : between_) sink_(event);
    between_.clear();
}

}  // namespace bead
