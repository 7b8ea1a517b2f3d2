#include "vibration/timed.h"

#include <algorithm>
#include <cmath>

#include "motion/jerk_limited.h"
#include "motion/trapezoid.h"
#include "vibration/point_speeds.h"

namespace bead {
namespace {

using Pieces = std::span<const Piece>;

constexpr double kept_way = 2.0;    // mm of told path that the next window's bends may need
constexpr double shortest = 1e-12;  // s, of a segment

// Limits of the pieces from `first` on; the path before only bends. Begins with the entry speed
// and ends at rest.
SpeedLimits limits_of(Pieces pieces, std::size_t first, double entry, const TimeLaw& law) {
    SpeedLimits limits;
    const std::vector<double> points = point_speeds(pieces, law);
    limits.point.assign(points.begin() + std::ptrdiff_t(first), points.end());
    limits.point.front() = entry;
    limits.jerk = law.jerk;
    for (const Piece& piece : pieces.subspan(first)) {
        limits.length.push_back(length(piece));
        limits.speed.push_back(piece.feed * law.feed_factor);
        limits.acceleration.push_back(acceleration_of(piece, law));
    }
    return limits;
}

// A plan by acceleration alone in the same form; `steady` where braking for the end does not reach.
SpeedPlan trapezoids(const SpeedLimits& limits) {
    const std::size_t n = limits.length.size();
    SpeedPlan plan;
    std::vector<double>& v = plan.speed = limits.point;
    for (std::size_t i = 0; i < n; ++i) {
        v[i] = std::min(v[i], limits.speed[i]);
        v[i + 1] = std::min(v[i + 1], limits.speed[i]);
    }
    const auto able = [&](double from, std::size_t i) {
        return std::sqrt(from * from + 2 * limits.acceleration[i] * limits.length[i]);
    };
    for (std::size_t i = 0; i < n; ++i) v[i + 1] = std::min(v[i + 1], able(v[i], i));
    plan.steady.assign(n + 1, true);
    for (std::size_t i = n; i-- > 0;) {
        plan.steady[i] = v[i] <= able(v[i + 1], i);
        v[i] = std::min(v[i], able(v[i + 1], i));
    }
    double t = 0, s = 0;
    const auto add_phase = [&](double duration, double entry, double a) {
        if (duration > shortest) plan.phases.push_back({t, s, entry, a, 0});
        t += duration;
        s += duration * (entry + duration * a / 2);
    };
    for (std::size_t i = 0; i < n; ++i) {
        plan.time.push_back(t);
        const double a = limits.acceleration[i];
        const Trapezoid r = trapezoid(limits.length[i], limits.speed[i], v[i], v[i + 1], a);
        add_phase(r.t_accel, r.v_entry, a);
        add_phase(r.t_cruise, r.v_peak, 0);
        add_phase(r.t_decel, r.v_peak, -a);
    }
    plan.time.push_back(t);
    plan.phases.push_back({t, s, v.back(), 0, 0});
    return plan;
}

SpeedPlan plan_of(const SpeedLimits& limits, const TimeLaw& law) {
    return law.profile == SpeedProfile::trapezoid ? trapezoids(limits) : jerk_limited(limits);
}

// A piece cut where the plan's phases change, from phase `k` on.
void tell(const Piece& piece, double nominal, double start, double stop, const SpeedPlan& plan,
          std::size_t& k, const SegmentSink& sink) {
    const double whole = length(piece);
    const Vec2 direction = (piece.to - piece.from) / whole;
    double t = start, done = 0;
    while (true) {
        const bool last_phase = k + 1 >= plan.phases.size();
        const double until = last_phase ? stop : std::min(stop, plan.phases[k + 1].t);
        const bool last = last_phase || plan.phases[k + 1].t >= stop;
        const JerkPhase& p = plan.phases[k];
        const double dt = std::max(0.0, t - p.t), duration = std::max(0.0, until - t);
        MotionSegment segment{.duration = duration,
                              .from = piece.from + done * direction,
                              .direction = direction,
                              .speed = std::max(0.0, p.v + dt * (p.a + dt * p.j / 2)),
                              .acceleration = p.a + dt * p.j,
                              .jerk = p.j,
                              .nominal = nominal,
                              .flow = piece.flow};
        segment.length =
            last ? whole - done : std::clamp(way(segment, duration), 0.0, whole - done);
        done += segment.length;
        if (duration > 0 || segment.length > 0) sink(segment);
        t = until;
        if (last) return;
        ++k;
    }
}

// The first `count` pieces of a plan.
void tell(Pieces pieces, std::size_t count, const SpeedPlan& plan, const TimeLaw& law,
          const SegmentSink& sink) {
    std::size_t phase = 0;
    for (std::size_t i = 0; i < count; ++i)
        tell(pieces[i], pieces[i].feed * law.feed_factor, plan.time[i], plan.time[i + 1], plan,
             phase, sink);
}

}  // namespace

void timed(std::span<const Piece> pieces, const TimeLaw& law, const SegmentSink& sink) {
    if (pieces.empty()) return;
    const SpeedPlan plan = plan_of(limits_of(pieces, 0, 0, law), law);
    tell(pieces, pieces.size(), plan, law, sink);
}

void Timing::add(const Piece& piece) {
    window_.push_back(piece);
    at_ = piece.to;
    if (window_.size() >= full_) release(false);
}

void Timing::stand(double duration) {
    release(true);
    window_.clear();
    gone_ = 0;
    if (duration > 0) sink_({.duration = duration, .from = at_});
}

void Timing::release(bool all) {
    const std::size_t fresh = window_.size() - gone_;
    if (fresh == 0) return;
    const SpeedPlan plan = plan_of(limits_of(window_, gone_, entry_, law_), law_);
    std::size_t count = fresh;
    if (!all) {
        count /= 2;
        while (count > 0 && !plan.steady[count]) --count;
        full_ = count > 0 ? gone_ + usual_window : 2 * full_;
    }
    tell(Pieces(window_).subspan(gone_), count, plan, law_, sink_);
    entry_ = all ? 0 : plan.speed[count];
    forget(gone_ + count);
}

// The first pieces are told; the last of them are kept for the bend of those to come.
void Timing::forget(std::size_t count) {
    std::size_t kept = count;
    for (double way = 0; kept > 0 && way < kept_way; --kept) way += length(window_[kept - 1]);
    window_.erase(window_.begin(), window_.begin() + std::ptrdiff_t(kept));
    gone_ = count - kept;
    full_ = std::max(full_, gone_ + usual_window);
}

}  // namespace bead
