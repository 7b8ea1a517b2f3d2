#include "smooth/chords.h"

#include <algorithm>
#include <utility>

namespace bead {
namespace {

constexpr double least_corner = 25 * pi / 180;  // rad, never shifted

// The arc tangent's series where it is right to two millionths: most turns are that small.
double turn_at(const Polyline& p, std::size_t i) {
    const Vec2 in = p[i] - p[i - 1], out = p[i + 1] - p[i];
    const double across = std::abs(cross(in, out)), ahead = dot(in, out);
    if (across > 0.25 * ahead) return std::atan2(across, ahead);
    const double t = across / ahead, square = t * t;
    return t * (1 - square * (1.0 / 3 - square * (1.0 / 5 - square / 7)));
}

struct ChordLimits {
    double tolerance, turn;  // mm, rad
};

ChordLimits limits_for(const Flow& flow, const ChordOptions& options) {
    if (flow.role == Role::travel) return {options.travel, options.travel_turn};
    const double turn = !options.fine_links && flow.ramp > 0 ? options.travel_turn : options.turn;
    return {flow.role == Role::infill ? options.infill : options.wall, turn};
}

// What does not change while a chord from one point is drawn out.
class ChordFrom {
  public:
    ChordFrom(const MeasuredRibbon& measured, std::size_t first, const ChordOptions& options)
        : measured_(measured),
          options_(options),
          first_(first),
          flow_(measured.ribbon.flows[first]),
          limits_(limits_for(flow_, options)),
          quieter_(1 / options.loudness),
          start_(measured.ribbon.points[first]) {}

    // To the farthest point that it may lead to, sought from `guess` points on: most chords are as
    // long as the one before.
    [[nodiscard]] std::size_t end(std::size_t guess) const {
        const std::vector<Flow>& flows = measured_.ribbon.flows;
        const auto begin = std::min<std::size_t>(first_ + guess, measured_.same_until[first_]);
        std::size_t end = begin;
        while (end > first_ + 1 && !may_lead_to(end)) --end;
        if (end < begin) return end;
        while (end < flows.size() &&
               (end < measured_.same_until[first_] || may_share(flows[end])) &&
               may_lead_to(end + 1))
            ++end;
        return end;
    }

  private:
    [[nodiscard]] bool may_share(const Flow& next) const {
        if (options_.fine_links || flow_.ramp == 0) return alike(flow_, next);
        return next.ramp > 0 && next.role == flow_.role && next.speed == flow_.speed;
    }

    [[nodiscard]] bool may_lead_to(std::size_t end) const {
        const double turn = measured_.turn[end - 1] - measured_.turn[first_];
        const double run = measured_.at[end] - measured_.at[first_];
        const bool tight = turn * options_.tight_radius > run;
        if (turn > (tight ? std::max(limits_.turn, options_.tight_turn) : limits_.turn))
            return false;
        const Vec2 along = measured_.ribbon.points[end] - start_;
        const double square = dot(along, along);
        if (square < 1e-18) return false;
        if (turn > 0.01 && !is_quiet(turn, run, square, tight)) return false;
        if (options_.step && !is_passed(end, turn, run)) return false;
        return stays_near(end, along, square);
    }

    [[nodiscard]] bool stays_near(std::size_t end, Vec2 along, double square) const {
        const Vec2* const points = measured_.ribbon.points.data();
        const double most = limits_.tolerance * limits_.tolerance * square;
        for (std::size_t k = first_ + 1; k < end; ++k) {
            const double area = cross(along, points[k] - start_);
            if (area * area > most) return false;
        }
        return true;
    }

    // Whether firmware need not brake where chords like this one meet: they turn there by what the
    // line turns from end to end, half of the corners at both ends included.
    [[nodiscard]] bool is_passed(std::size_t end, double turn, double run) const {
        if (flow_.role == Role::travel) return true;
        const bool slowed = flow_.speed * flow_.speed * turn > options_.acceleration * run;
        const double speed = slowed ? std::sqrt(options_.acceleration * run / turn) : flow_.speed;
        return options_.step->allows(speed * (measured_.along[end] - measured_.along[first_]));
    }

    // Whether chords of that length, in a bend like this, push so far above the modes that the
    // machine hardly answers, in steps of speed that firmware need not brake for. All in squares:
    // v² for r f0 l, and (r² - 1)³ / r >= share² as (v² - q)⁶ >= v² q⁵ share⁴ with q = (f0 l)².
    [[nodiscard]] bool is_quiet(double turn, double run, double square, bool tight) const {
        const double asked = flow_.speed * flow_.speed, most = options_.acceleration;
        const bool slowed = asked * turn > most * run;
        const double speed = slowed ? most * run / turn : asked;
        const double acceleration = slowed ? most : asked * turn / run;
        if (acceleration <= options_.quiet || flow_.role == Role::travel) return true;
        const bool steps = speed * turn * turn > options_.velocity_step * options_.velocity_step;
        if (steps && !tight && !options_.step) return false;
        const double q = square * options_.frequency * options_.frequency, above = speed - q;
        if (above <= 0) return false;
        const double share = acceleration * quieter_, share2 = share * share, q2 = q * q;
        const double cube = above * above * above;
        return cube * cube >= speed * q * q2 * q2 * share2 * share2;
    }

    const MeasuredRibbon& measured_;
    const ChordOptions& options_;
    std::size_t first_;
    const Flow& flow_;
    ChordLimits limits_;
    double quieter_;  // 1 / loudness
    Vec2 start_;
};

// Calls visit(the point where it ends) for every chord.
template <typename Visit>
void for_chords(const MeasuredRibbon& measured, const ChordOptions& options, const Visit& visit) {
    std::size_t last = 1;
    for (std::size_t i = 0; i + 1 < measured.ribbon.points.size();) {
        const std::size_t end = ChordFrom(measured, i, options).end(last);
        last = end - i;
        i = end;
        visit(end);
    }
}

std::vector<std::size_t> chosen(const MeasuredRibbon& measured, const ChordOptions& options) {
    std::vector<std::size_t> kept{0};
    for_chords(measured, options, [&](std::size_t end) { kept.push_back(end); });
    return kept;
}

// How far the line lies to the left of the chord, on average.
double mean_bulge(const Polyline& p, std::size_t i, std::size_t j) {
    double twice_area = 0;
    for (std::size_t k = i + 1; k + 1 <= j; ++k) twice_area += cross(p[k] - p[i], p[k + 1] - p[i]);
    const double far = distance(p[i], p[j]);
    return far > 0 ? -twice_area / (2 * far) : 0;
}

Vec2 shifted(const Polyline& p, std::size_t before, std::size_t here, std::size_t after) {
    const Vec2 in = p[here] - p[before], out = p[after] - p[here];
    if (std::abs(cross(in, out)) > std::tan(least_corner) * dot(in, out)) return p[here];
    const double bulge = (mean_bulge(p, before, here) + mean_bulge(p, here, after)) / 2;
    const Vec2 along = in / length(in) + out / length(out);
    return p[here] + bulge * left_of(along / length(along));
}

// Half way between two directions; the second where there is none.
Vec2 between(Vec2 before, Vec2 after) {
    const Vec2 both = before + after;
    const double size = length(both);
    return size > 1e-9 ? both / size : after;
}

}  // namespace

MeasuredRibbon measured(Ribbon ribbon) {
    MeasuredRibbon result{std::move(ribbon), {0}, {0}, {}, {}};
    const Polyline& p = result.ribbon.points;
    result.at.reserve(p.size());
    result.turn.reserve(p.size());
    const std::vector<Flow>& flows = result.ribbon.flows;
    result.same_until.resize(flows.size());
    for (std::size_t i = flows.size(); i-- > 0;) {
        const bool on = i + 1 < flows.size() && flows[i] == flows[i + 1];
        result.same_until[i] = on ? result.same_until[i + 1] : static_cast<std::uint32_t>(i + 1);
    }
    result.along.reserve(p.size());
    Vec2 before{};
    for (std::size_t i = 1; i < p.size(); ++i) {
        const Vec2 way = p[i] - p[i - 1];
        const double far = length(way);
        const Vec2 after = far > 0 ? way / far : before;
        result.at.push_back(result.at.back() + far);
        result.turn.push_back(result.turn.back() + (i + 1 < p.size() ? turn_at(p, i) : 0));
        result.along.push_back(between(before, after));
        before = after;
    }
    if (!p.empty()) result.along.push_back(before);
    return result;
}

std::size_t chord_count(const MeasuredRibbon& measured, const ChordOptions& options) {
    if (measured.ribbon.points.size() < 3) return measured.ribbon.flows.size();
    std::size_t count = 0;
    for_chords(measured, options, [&](std::size_t) { ++count; });
    return count;
}

Ribbon chorded(const MeasuredRibbon& measured, const ChordOptions& options) {
    const Ribbon& ribbon = measured.ribbon;
    if (ribbon.points.size() < 3) return ribbon;
    const std::vector<std::size_t> kept = chosen(measured, options);
    Ribbon result;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const bool inner = k > 0 && k + 1 < kept.size();
        result.points.push_back(inner ? shifted(ribbon.points, kept[k - 1], kept[k], kept[k + 1])
                                      : ribbon.points[kept[k]]);
        if (k == 0) continue;
        Flow flow = ribbon.flows[kept[k - 1]];
        double deposited = 0;
        for (std::size_t i = kept[k - 1]; i < kept[k]; ++i)
            deposited += ribbon.flows[i].section * (measured.at[i + 1] - measured.at[i]);
        if (flow.ramp > 0)
            flow.section = deposited / (measured.at[kept[k]] - measured.at[kept[k - 1]]);
        result.flows.push_back(flow);
    }
    return result;
}

}  // namespace bead
