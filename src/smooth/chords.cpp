#include "smooth/chords.h"

#include <algorithm>
#include <utility>

namespace bead {
namespace {

constexpr double least_corner = 25 * pi / 180;  // rad, never shifted

// The arc tangent's series where it is right to a millionth: most turns are that small.
double turn_at(const Polyline& p, std::size_t i) {
    const Vec2 in = p[i] - p[i - 1], out = p[i + 1] - p[i];
    const double across = std::abs(cross(in, out)), ahead = dot(in, out);
    if (across > 0.05 * ahead) return std::atan2(across, ahead);
    const double t = across / ahead;
    return t * (1 - t * t / 3);
}

struct Limits {
    double tolerance, turn;  // mm, rad
};

Limits limits_for(const Flow& flow, const ChordOptions& options) {
    if (flow.role == Role::travel) return {options.travel, options.travel_turn};
    if (flow.role == Role::infill) return {options.infill, options.turn};
    return {options.wall, options.turn};
}

// Whether chords that push at r times the mode do so quietly enough.
bool is_quiet(double r, double acceleration, double loudness) {
    const double above = r * r - 1, share = acceleration / loudness;
    return r > 1 && above * above * above >= r * share * share;
}

bool is_allowed(const MeasuredRibbon& measured, std::size_t i, std::size_t j,
                const ChordOptions& options) {
    const Flow& flow = measured.ribbon.flows[i];
    const Limits limits = limits_for(flow, options);
    const double turn = measured.turn[j - 1] - measured.turn[i];
    const double run = measured.at[j] - measured.at[i];
    const bool tight = turn * options.tight_radius > run;
    if (turn > (tight ? std::max(limits.turn, options.tight_turn) : limits.turn)) return false;
    const Vec2 a = measured.ribbon.points[i], along = measured.ribbon.points[j] - a;
    const double far = length(along);
    if (far < 1e-9) return false;
    for (std::size_t k = i + 1; k < j; ++k)
        if (std::abs(cross(along, measured.ribbon.points[k] - a)) > limits.tolerance * far)
            return false;
    if (turn <= 0.01) return true;
    const double curvature = turn / run;
    const double speed = std::min(flow.speed, std::sqrt(options.acceleration / curvature));
    const double acceleration = speed * speed * curvature;
    if (acceleration <= options.quiet || flow.role == Role::travel) return true;
    if (!tight && speed * turn > options.velocity_step) return false;
    return is_quiet(speed / (far * options.frequency), acceleration, options.loudness);
}

std::vector<std::size_t> chosen(const MeasuredRibbon& measured, const ChordOptions& options) {
    std::vector<std::size_t> kept{0};
    const std::size_t n = measured.ribbon.points.size();
    for (std::size_t i = 0; i + 1 < n; i = kept.back()) {
        std::size_t j = i + 1;
        while (j + 1 < n && alike(measured.ribbon.flows[i], measured.ribbon.flows[j]) &&
               is_allowed(measured, i, j + 1, options))
            ++j;
        kept.push_back(j);
    }
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
    if (std::atan2(std::abs(cross(in, out)), dot(in, out)) > least_corner) return p[here];
    const double bulge = (mean_bulge(p, before, here) + mean_bulge(p, here, after)) / 2;
    const Vec2 along = in / length(in) + out / length(out);
    return p[here] + bulge * left_of(along / length(along));
}

}  // namespace

MeasuredRibbon measured(Ribbon ribbon) {
    MeasuredRibbon result{std::move(ribbon), {0}, {0}};
    const Polyline& p = result.ribbon.points;
    for (std::size_t i = 1; i < p.size(); ++i) {
        result.at.push_back(result.at.back() + distance(p[i - 1], p[i]));
        result.turn.push_back(result.turn.back() + (i + 1 < p.size() ? turn_at(p, i) : 0));
    }
    return result;
}

std::size_t chord_count(const MeasuredRibbon& measured, const ChordOptions& options) {
    if (measured.ribbon.points.size() < 3) return measured.ribbon.flows.size();
    return chosen(measured, options).size() - 1;
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
