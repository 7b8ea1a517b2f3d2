#include "motion/jerk_limited.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/expects.h"
#include "motion/jerk_ramp.h"

namespace bead {
namespace {

constexpr double tolerance = 1e-9;  // relative, of speeds at a point against its limit
constexpr double no_rise = 1.03;    // a peak that gains less than this is not worth two ramps
constexpr double shortest = 1e-12;  // s, of a phase

struct Anchor {
    std::size_t point = 0;
    double v = 0;
};

struct Stretch {                   // between two anchors
    std::size_t from = 0, to = 0;  // their points
    double start = 0, end = 0;     // mm
    double in = 0, peak = 0, out = 0;
    double fastest = 0;  // of its pieces' limits of speed
    JerkLimits limits;
    bool known = false, obeys = false;  // peak is that of in and out; no point's limit is exceeded
    [[nodiscard]] double length() const { return end - start; }
};

class Planning {
  public:
    explicit Planning(const SpeedLimits& limits) : limits_(limits), count_(limits.length.size()) {
        place_.resize(count_ + 1);
        for (std::size_t i = 0; i < count_; ++i) place_[i + 1] = place_[i] + limits.length[i];
        cap_ = limits.point;
        for (std::size_t i = 0; i < count_; ++i) {
            cap_[i] = std::min(cap_[i], limits.speed[i]);
            cap_[i + 1] = std::min(cap_[i + 1], limits.speed[i]);
        }
    }

    SpeedPlan plan() {
        find_anchors();
        make_stretches();
        refine();
        // Anchors that turned out slower than they may be need not be places of rest.
        std::erase_if(anchors_, [&](const Anchor& anchor) {
            return anchor.point != 0 && anchor.point != count_ &&
                   anchor.v < cap_[anchor.point] * (1 - tolerance);
        });
        make_stretches();
        refine();
        return told();
    }

  private:
    // A plan with acceleration alone, and the points that it passes at their own limit in a local
    // minimum: both ends of every such plateau.
    void find_anchors() {
        std::vector<double> v = cap_;
        for (std::size_t i = 0; i < count_; ++i) v[i + 1] = std::min(v[i + 1], able(v[i], i));
        for (std::size_t i = count_; i-- > 0;) v[i] = std::min(v[i], able(v[i + 1], i));
        anchors_.push_back({0, 0});
        for (std::size_t i = 1; i < count_;) {
            std::size_t last = i;
            while (last + 1 < count_ && v[last + 1] == v[i]) ++last;
            if (v[i - 1] > v[i] && v[last + 1] > v[i] && v[i] == cap_[i]) {
                anchors_.push_back({i, 0});
                if (last > i) anchors_.push_back({last, 0});
            }
            i = last + 1;
        }
        anchors_.push_back({count_, 0});
    }

    [[nodiscard]] double able(double v, std::size_t piece) const {
        return std::sqrt(v * v + 2 * limits_.acceleration[piece] * limits_.length[piece]);
    }

    [[nodiscard]] Stretch stretch(std::size_t from, std::size_t to) const {
        const auto acceleration = limits_.acceleration.begin(), speed = limits_.speed.begin();
        const auto first = std::ptrdiff_t(from), last = std::ptrdiff_t(to);
        Stretch s;
        s.from = from;
        s.to = to;
        s.start = place_[from];
        s.end = place_[to];
        s.limits = {*std::min_element(acceleration + first, acceleration + last), limits_.jerk};
        s.fastest = *std::max_element(speed + first, speed + last);
        return s;
    }

    void make_stretches() {
        stretches_.clear();
        for (std::size_t i = 0; i + 1 < anchors_.size(); ++i)
            stretches_.push_back(stretch(anchors_[i].point, anchors_[i + 1].point));
    }

    void refine() {
        do {
            level_anchors();
        } while (add_anchors());
    }

    // Every anchor at its limit, lowered to what the ramps from its neighbours can reach.
    void level_anchors() {
        for (Anchor& anchor : anchors_) anchor.v = cap_[anchor.point];
        for (std::size_t i = 0; i < stretches_.size(); ++i) limit(anchors_[i + 1], anchors_[i], i);
        for (std::size_t i = stretches_.size(); i-- > 0;) limit(anchors_[i], anchors_[i + 1], i);
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            Stretch& s = stretches_[i];
            const double in = anchors_[i].v, out = anchors_[i + 1].v;
            if (s.known && s.in == in && s.out == out) continue;
            s.in = in;
            s.out = out;
            set_peak(s);
            s.known = true;
            s.obeys = false;
        }
    }

    void limit(Anchor& anchor, const Anchor& from, std::size_t stretch) const {
        const Stretch& s = stretches_[stretch];
        if (anchor.v > from.v) anchor.v = std::min(anchor.v, reach(from.v, s.length(), s.limits));
    }

    // As fast as the stretch allows, but no faster than the piece on which it is fastest.
    void set_peak(Stretch& s) const {
        const std::size_t from = s.from, to = s.to;
        double cap = s.fastest;
        for (int round = 0; round < 6; ++round) {
            s.peak = peak_speed(s.in, s.out, s.length(), cap, s.limits);
            const double top = s.start + ramp_distance(s.in, s.peak, s.limits);
            const std::size_t piece = std::clamp(piece_at(top), from, to - 1);
            if (limits_.speed[piece] >= s.peak) break;
            cap = limits_.speed[piece];
        }
        const double least = std::max(s.in, s.out);
        if (s.peak < no_rise * least) s.peak = least;
    }

    [[nodiscard]] std::size_t piece_at(double place) const {
        const auto next = std::upper_bound(place_.begin(), place_.end(), place);
        return std::size_t(std::max<std::ptrdiff_t>(1, next - place_.begin())) - 1;
    }

    // In every stretch the slowest point whose limit is exceeded; false if there is none.
    bool add_anchors() {
        std::vector<Anchor> anchors{anchors_.front()};
        std::vector<Stretch> stretches;
        for (Stretch& s : stretches_) {
            const std::size_t point = s.obeys ? 0 : worst_point(s);
            if (point == 0) {
                s.obeys = true;
                stretches.push_back(s);
            } else {
                stretches.push_back(stretch(s.from, point));
                stretches.push_back(stretch(point, s.to));
                anchors.push_back({point, 0});
            }
            anchors.push_back({s.to, 0});
        }
        const bool added = anchors.size() > anchors_.size();
        if (!added) return false;
        anchors_.swap(anchors);
        stretches_.swap(stretches);
        return true;
    }

    std::size_t worst_point(const Stretch& s) {
        const std::size_t from = s.from, to = s.to;
        if (to - from < 2) return 0;
        phases_.clear();
        add_phases(s, 0, phases_);
        const double middle = (s.start + s.end) / 2;
        std::size_t worst = 0, phase = 0;
        for (std::size_t i = from + 1; i < to; ++i) {
            if (pass(place_[i], phase).v <= cap_[i] * (1 + tolerance)) continue;
            const bool nearer = worst != 0 && cap_[i] == cap_[worst] &&
                                std::abs(place_[i] - middle) < std::abs(place_[worst] - middle);
            if (worst == 0 || cap_[i] < cap_[worst] || nearer) worst = i;
        }
        return worst;
    }

    static void add_phases(const Stretch& s, double t, std::vector<JerkPhase>& phases) {
        JerkPhase at{t, s.start, s.in, 0, 0};
        add_ramp(at, s.peak, s.limits, phases);
        const double cruise = s.length() - ramp_distance(s.in, s.peak, s.limits) -
                              ramp_distance(s.peak, s.out, s.limits);
        if (cruise > 0 && s.peak > 0) add_phase(at, cruise / s.peak, 0, 0, phases);
        add_ramp(at, s.out, s.limits, phases);
        at.s = s.end;  // rounding
        at.v = s.out;
        phases.push_back(at);
    }

    static void add_ramp(JerkPhase& at, double to, const JerkLimits& limits,
                         std::vector<JerkPhase>& phases) {
        const double change = std::abs(to - at.v), sign = to > at.v ? 1 : -1;
        if (change == 0) return;
        const double a = std::min(limits.acceleration, std::sqrt(change * limits.jerk));
        const double rise = a / limits.jerk, hold = std::max(0.0, change / a - rise);
        add_phase(at, rise, 0, sign * limits.jerk, phases);
        if (hold > shortest) add_phase(at, hold, sign * a, 0, phases);
        add_phase(at, rise, sign * a, -sign * limits.jerk, phases);
        at.v = to;
    }

    static void add_phase(JerkPhase& at, double t, double a, double j,
                          std::vector<JerkPhase>& phases) {
        at.a = a;
        at.j = j;
        phases.push_back(at);
        at.s += t * (at.v + t * (a / 2 + t * j / 6));
        at.v = std::max(0.0, at.v + t * (a + t * j / 2));
        at.t += t;
        at.a = at.j = 0;
    }

    // The state at a place in phases_, from the given phase on.
    [[nodiscard]] JerkPhase pass(double place, std::size_t& phase) const {
        while (phase + 2 < phases_.size() && phases_[phase + 1].s <= place) ++phase;
        const JerkPhase& p = phases_[phase];
        const double way = place - p.s, longest = phases_[phase + 1].t - p.t;
        const double t = time_after(p, way, longest);
        return {p.t + t, place, std::max(0.0, p.v + t * (p.a + t * p.j / 2)), p.a + t * p.j, p.j};
    }

    // Newton within brackets.
    static double time_after(const JerkPhase& p, double way, double longest) {
        if (way <= 0) return 0;
        double low = 0, high = longest;
        double t = p.v > 0 ? std::min(longest, way / p.v) : longest;
        for (int i = 0; i < 60; ++i) {
            const double off = t * (p.v + t * (p.a / 2 + t * p.j / 6)) - way;
            (off > 0 ? high : low) = t;
            const double v = p.v + t * (p.a + t * p.j / 2);
            double next = v > 0 ? t - off / v : (low + high) / 2;
            if (!(next >= low && next <= high)) next = (low + high) / 2;
            if (std::abs(next - t) <= 1e-14 * (1 + t)) return next;
            t = next;
        }
        return t;
    }

    SpeedPlan told() {
        phases_.clear();
        for (const Stretch& s : stretches_) {
            const double t = phases_.empty() ? 0 : phases_.back().t;
            if (!phases_.empty()) phases_.pop_back();
            add_phases(s, t, phases_);
        }
        SpeedPlan plan;
        plan.speed.resize(count_ + 1);
        plan.time.resize(count_ + 1);
        plan.steady.resize(count_ + 1);
        std::size_t phase = 0;
        for (std::size_t i = 0; i <= count_; ++i) {
            const JerkPhase at = i == count_ ? phases_.back() : pass(place_[i], phase);
            plan.speed[i] = at.v;
            plan.time[i] = at.t;
            plan.steady[i] = phases_[phase].a == 0 && phases_[phase].j == 0;
        }
        for (const Anchor& anchor : anchors_) {
            plan.speed[anchor.point] = anchor.v;
            plan.steady[anchor.point] = true;
        }
        plan.phases = std::move(phases_);
        return plan;
    }

    const SpeedLimits& limits_;
    const std::size_t count_;
    std::vector<double> place_, cap_;
    std::vector<Anchor> anchors_;
    std::vector<Stretch> stretches_;
    std::vector<JerkPhase> phases_;
};

}  // namespace

SpeedPlan jerk_limited(const SpeedLimits& limits) {
    const std::size_t count = limits.length.size();
    BEAD_EXPECTS(count > 0 && limits.speed.size() == count && limits.acceleration.size() == count &&
                 limits.point.size() == count + 1 && limits.jerk > 0);
    return Planning(limits).plan();
}

}  // namespace bead
