#include "motion/prusa.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/expects.h"
#include "motion/limit_changes.h"
#include "motion/steps.h"
#include "motion/trapezoid.h"

namespace bead {
namespace {

constexpr double least_feed = 0.05;  // mm/s; slower is taken as this
constexpr double halt_preference =
    0.99;                       // a halt is taken when it is at most 1 % slower than coasting
constexpr double still = 1e-4;  // mm/s, below this the machine stands
constexpr std::size_t look_every = 256;  // blocks between two searches for settled ones

// Speed at the start of a stretch at whose end `v_end` is due.
double allowed(double acceleration, double v_end, double length) {
    return std::sqrt(v_end * v_end + 2 * acceleration * length);
}

// Step of an axis' speed from p to q: the difference when it goes on in its direction, else it has
// to stop and start again and the larger part counts.
double jerk_of(double p, double q) {
    if (p > q) return (q > 0 || p < 0) ? p - q : std::max(p, -q);
    return (q < 0 || p > 0) ? q - p : std::max(-p, q);
}

std::int64_t longest(const PerAxis<std::int64_t>& steps) {
    std::int64_t most = 0;
    for (const std::int64_t n : steps) most = std::max<std::int64_t>(most, std::abs(n));
    return most;
}

bool moves_head(const PerAxis<std::int64_t>& steps, std::int64_t ignored) {
    return std::abs(steps[axis_x]) > ignored || std::abs(steps[axis_y]) > ignored ||
           std::abs(steps[axis_z]) > ignored;
}

double path_length(const PerAxis<double>& delta, bool head_moves) {
    return head_moves ? length(Vec3{delta[axis_x], delta[axis_y], delta[axis_z]})
                      : std::abs(delta[axis_e]);
}

}  // namespace

PrusaPlanner::PrusaPlanner(const Limits& limits, const PrusaOptions& options, MotionSink sink)
    : limits_(limits), options_(options), sink_(std::move(sink)), next_look_(look_every) {
    BEAD_EXPECTS(options.lookahead == 0 || options.lookahead >= 4);
}

void PrusaPlanner::add(const Command& command) {
    struct Act {
        PrusaPlanner& planner;
        std::int64_t line;
        void operator()(const Move& m) const { planner.move(m, line); }
        void operator()(const Arc& arc) const { planner.move(arc.end, line); }
        void operator()(const SetPosition& p) const { planner.set_position(p); }
        void operator()(const Home& home) const {
            planner.drain();
            for (std::size_t i = 0; i < home.axes.size(); ++i)
                if (home.axes[i]) planner.steps_[i] = 0;
        }
        void operator()(const Dwell& dwell) const {
            planner.drain();
            planner.sink_(dwell);
        }
        void operator()(const Drain&) const { planner.drain(); }
        void operator()(const SetHeat& heat) const {
            if (heat.wait) planner.drain();
            planner.pass(heat);
        }
        void operator()(const SetFan& fan) const { planner.pass(fan); }
        void operator()(const LayerStart& layer) const { planner.pass(layer); }
        void operator()(const SetLimits& change) const {
            planner.limits_ = changed(planner.limits_, change);
        }
    };
    std::visit(Act{*this, command.line}, command.what);
}

void PrusaPlanner::finish() { drain(); }

void PrusaPlanner::pass(const MotionEvent& event) {
    if (queue_.empty())
        sink_(event);
    else
        pending_.push_back(event);
}

void PrusaPlanner::set_position(const SetPosition& position) {
    const bool head = position.to[axis_x] || position.to[axis_y] || position.to[axis_z];
    if (head || position.to[axis_e].value_or(0) != 0) drain();
    if (head) previous_ = {};
    for (std::size_t i = 0; i < steps_.size(); ++i)
        if (position.to[i]) steps_[i] = steps_at(*position.to[i], limits_.steps_per_mm[i]);
}

void PrusaPlanner::move(const Move& move, std::int64_t line) {
    PerAxis<std::int64_t> target{}, steps{};
    Planned planned;
    Block& block = planned.block;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        target[i] = steps_at(move.to[i], limits_.steps_per_mm[i]);
        steps[i] = target[i] - steps_[i];
        block.delta[i] = static_cast<double>(steps[i]) / limits_.steps_per_mm[i];
    }
    if (longest(steps) <= limits_.drop_segments) return;  // joins the next move
    steps_ = target;

    block.line = line;
    block.role = move.role;
    block.bead = move.bead;
    block.length = path_length(block.delta, moves_head(steps, limits_.drop_segments));
    const double feed = std::max(move.feed, least_feed);
    double scale = 1;
    PerAxis<double> speed{};
    for (std::size_t i = 0; i < speed.size(); ++i) {
        speed[i] = feed * block.delta[i] / block.length;
        if (std::abs(speed[i]) > limits_.max_feedrate[i])
            scale = std::min(scale, limits_.max_feedrate[i] / std::abs(speed[i]));
    }
    for (double& v : speed) v *= scale;
    block.v_nominal = feed * scale;
    block.acceleration = path_acceleration(steps, block);
    planned.before = std::move(pending_);
    pending_.clear();
    if (options_.lookahead > 0 &&
        queue_.size() + 1 >= static_cast<std::size_t>(options_.lookahead)) {
        release_front();
        run_front();
    }
    enter(planned, speed);
    enqueue(std::move(planned));
}

double PrusaPlanner::path_acceleration(const PerAxis<std::int64_t>& steps, const Block& b) const {
    const bool retract = !moves_head(steps, 0);
    const double asked = retract              ? limits_.retract_acceleration
                         : steps[axis_e] == 0 ? limits_.travel_acceleration
                                              : limits_.acceleration;
    if (!options_.quirks.crude_axis_cap) {
        double capped = asked;
        for (std::size_t i = 0; i < steps.size() && !retract; ++i)
            if (steps[i] != 0)
                capped =
                    std::min(capped, limits_.max_acceleration[i] * b.length / std::abs(b.delta[i]));
        return capped;
    }
    const auto most = static_cast<double>(longest(steps));
    const double steps_per_mm = most / b.length;
    double rate = std::ceil(asked * steps_per_mm);
    for (const Axis i : {axis_x, axis_y, axis_e, axis_z}) {
        const double axis_most = limits_.max_acceleration[i] * limits_.steps_per_mm[i];
        const auto axis_steps = static_cast<double>(std::abs(steps[i]));
        if (!retract && rate * axis_steps / most > axis_most) rate = axis_most;
    }
    return rate / steps_per_mm;
}

double PrusaPlanner::safe_speed(const Block& block, const PerAxis<double>& speed) const {
    double safe = block.v_nominal;
    bool limited = false;
    for (std::size_t i = 0; i < speed.size(); ++i) {
        const double v = std::abs(speed[i]);
        if (v <= limits_.jerk[i]) continue;
        const double on_path = block.v_nominal * limits_.jerk[i] / v;
        const bool first = options_.quirks.crude_safe_speed && !limited;
        safe = first ? limits_.jerk[i] : std::min(safe, on_path);
        limited = true;
    }
    return safe;
}

// Path speed at which every axis' step stays within its jerk, both blocks having slowed to it.
double PrusaPlanner::junction_speed(const Block& block, const PerAxis<double>& speed) const {
    const double common = std::min(block.v_nominal, previous_.nominal);
    const double before = common / previous_.nominal;
    const double after = options_.quirks.unscaled_entry ? 1.0 : common / block.v_nominal;
    double factor = 1;
    for (std::size_t i = 0; i < speed.size(); ++i) {
        const double jerk = jerk_of(before * previous_.speed[i], after * speed[i]);
        if (jerk > limits_.jerk[i]) factor = std::min(factor, limits_.jerk[i] / jerk);
    }
    return common * factor;
}

void PrusaPlanner::enter(Planned& planned, const PerAxis<double>& speed) {
    const Block& block = planned.block;
    planned.safe = safe_speed(block, speed);
    const std::int64_t needed = options_.quirks.second_block_halts ? 2 : 1;
    planned.halt = since_drain_ < needed || previous_.nominal <= still;
    double entry = planned.safe;
    if (!planned.halt) {
        const double junction = junction_speed(block, speed);
        const double threshold = halt_preference * junction;
        planned.halt = previous_.safe > threshold && planned.safe > threshold;
        if (!planned.halt) entry = junction;
    }
    const double brake = allowed(block.acceleration, planned.safe, block.length);
    planned.max_entry = entry;
    planned.entry = planned.brake_entry = std::min(entry, brake);
    planned.nominal = options_.quirks.nominal_shortcut && block.v_nominal <= brake;
    previous_ = {speed, block.v_nominal, planned.safe};
    ++since_drain_;
}

void PrusaPlanner::enqueue(Planned planned) {
    queue_.push_back(std::move(planned));
    sweep();
    if (options_.lookahead == 0 && queue_.size() >= next_look_) {
        release(settled());
        next_look_ = queue_.size() + look_every;
    }
}

void PrusaPlanner::sweep() { sweep_forward(sweep_back()); }

// Whether a block starts from a halt that the block before it knows nothing of.
bool PrusaPlanner::is_apart(const Planned& planned) const {
    return planned.halt && !options_.quirks.shared_halt_speed;
}

// The speed that block k has to have come down to at its end.
double PrusaPlanner::end_speed(std::size_t k) const {
    const Planned& planned = queue_[k];
    if (k + 1 == queue_.size()) return planned.safe;
    const Planned& next = queue_[k + 1];
    return is_apart(next) ? planned.safe : next.entry;
}

// From the newest block back: entries as high as braking allows, as far as the newest block makes a
// difference. Returns the last block that stays as it was.
std::size_t PrusaPlanner::sweep_back() {
    const PrusaQuirks& quirks = options_.quirks;
    std::size_t k = queue_.size() - 1;
    double end = queue_[k].brake_entry;
    while (k-- > 0) {
        Planned& planned = queue_[k];
        if (planned.pinned || (planned.halt && quirks.unbounded_halt)) return k;
        if (is_apart(queue_[k + 1])) end = planned.safe;
        const bool at_most =
            planned.nominal || (quirks.at_most_stays && planned.entry == planned.max_entry);
        const double brake = allowed(planned.block.acceleration, end, planned.block.length);
        end = at_most ? planned.max_entry : std::min(planned.max_entry, brake);
        if (end == planned.brake_entry) return k;
        planned.brake_entry = planned.entry = end;
    }
    return 0;
}

// From there on: entries no higher than the block before can reach.
void PrusaPlanner::sweep_forward(std::size_t unchanged) {
    for (std::size_t k = unchanged + 1; k < queue_.size(); ++k) {
        const Planned& before = queue_[k - 1];
        Planned& planned = queue_[k];
        if (planned.pinned) continue;
        planned.entry = planned.brake_entry;
        if (is_apart(planned) || before.nominal || before.entry >= planned.entry) continue;
        planned.entry = std::min(
            planned.entry, allowed(before.block.acceleration, before.entry, before.block.length));
    }
}

// How many blocks at the front no later block can change: those before the last one that is entered
// at its maximum even if the machine had to stop right after what is known.
std::size_t PrusaPlanner::settled() const {
    const PrusaQuirks& quirks = options_.quirks;
    double v = 0;
    for (std::size_t k = queue_.size() - 1; k >= 1; --k) {
        const Planned& planned = queue_[k];
        const bool stays = quirks.at_most_stays && planned.brake_entry == planned.max_entry;
        v = allowed(planned.block.acceleration, v, planned.block.length);
        if (planned.halt || stays || planned.nominal || v >= planned.max_entry) return k;
    }
    return 0;
}

void PrusaPlanner::release(std::size_t count) {
    for (; count > 0; --count) release_front();
    if (!queue_.empty()) queue_.front().pinned = !is_apart(queue_.front());
}

// The oldest block is done.
void PrusaPlanner::release_front() {
    Planned& planned = queue_.front();
    Block& block = planned.block;
    const Trapezoid t =
        trapezoid(block.length, block.v_nominal, planned.entry,
                  planned.running ? block.v_exit : end_speed(0), block.acceleration);
    block.v_entry = t.v_entry;
    block.v_peak = t.v_peak;
    block.v_exit = t.v_exit;
    block.t_accel = t.t_accel;
    block.t_cruise = t.t_cruise;
    block.t_decel = t.t_decel;
    for (const MotionEvent& event : planned.before) sink_(event);
    sink_(block);
    queue_.pop_front();
}

// The oldest block begins to run: how it is entered and left is final.
void PrusaPlanner::run_front() {
    Planned& front = queue_.front();
    front.block.v_exit = end_speed(0);
    front.running = front.pinned = true;
    if (!options_.quirks.late_raise && queue_.size() > 1 && !is_apart(queue_[1]))
        queue_[1].pinned = true;
}

void PrusaPlanner::drain() {
    release(queue_.size());
    for (const MotionEvent& event : pending_) sink_(event);
    pending_.clear();
    since_drain_ = 0;
    next_look_ = look_every;
}

}  // namespace bead
