#include "geom/equal_chords.h"

#include <algorithm>
#include <optional>

#include "core/expects.h"

namespace bead {
namespace {

struct Step {
    double parameter = 0;
    CurvePlace place;
    int corrections = 0;
};

double foretold(const CurvePlace& place, double chord) {
    const double square = dot(place.first, place.first);
    if (square <= 0) return 0;
    const double ahead = chord / std::sqrt(square);
    return ahead - dot(place.first, place.second) * ahead * ahead / (2 * square);
}

// Where the chord has its length by its first and second derivative; none when it does not grow.
std::optional<double> corrected(const Step& step, Vec2 way, double chord) {
    const double far = length(way), off = far - chord;
    const double slope = dot(way, step.place.first) / far;
    if (slope <= 0) return std::nullopt;
    const double bend =
        (dot(step.place.first, step.place.first) + dot(way, step.place.second) - slope * slope) /
        far;
    const double square = slope * slope, rest = 0.5 * off * bend;
    const double plain = off / slope;
    return step.parameter - (std::abs(rest) < 0.5 * square ? plain / (1 - rest / square) : plain);
}

// Between `low`, where the chord is too short, and `high`, where it is too long or nothing is
// known yet. None when the curve ends before the chord is reached.
std::optional<Step> next_step(const Nurbs& curve, const Step& from, double chord,
                              const ChordOptions& options) {
    const Vec2 start = from.place.point;
    const double end = last_parameter(curve);
    const double plain = chord / std::max(length(from.place.first), 1e-12 * chord);
    double ahead = foretold(from.place, chord);
    // Where the curve speeds up or slows down much within a chord the foretold step is useless.
    if (ahead < 0.2 * plain || ahead > 3 * plain) ahead = plain;
    double low = from.parameter, high = end;
    bool bounded = false;
    Step next{std::min(low + ahead, end), {}, 0};
    for (;; ++next.corrections) {
        next.place = curve_at(curve, next.parameter);
        const Vec2 way = next.place.point - start;
        const double far = length(way), off = far - chord;
        if (next.parameter >= end && off < 0) return std::nullopt;
        if (std::abs(off) <= options.tolerance * chord || next.corrections >= options.most_steps)
            return next;
        (off < 0 ? low : high) = next.parameter;
        bounded = bounded || off > 0;
        double to = corrected(next, way, chord).value_or(end + 1);
        if (!bounded) {
            const double farthest = next.parameter + 2 * (next.parameter - from.parameter);
            next.parameter = std::min({to, farthest, end});
        } else {
            next.parameter = to > low && to < high ? to : 0.5 * (low + high);
        }
        if (next.parameter <= low || (bounded && next.parameter >= high)) return next;  // rounding
    }
}

}  // namespace

ChordWalk equal_chords(const Nurbs& curve, double chord, const ChordOptions& options) {
    BEAD_EXPECTS(chord > 0 && options.tolerance > 0);
    const double end = last_parameter(curve);
    std::optional<Step> step{{first_parameter(curve), {}, 0}};
    step->place = curve_at(curve, step->parameter);
    ChordWalk walk;
    for (; step; step = next_step(curve, *step, chord, options)) {
        walk.points.push_back(step->place.point);
        walk.parameters.push_back(step->parameter);
        walk.steps.push_back(step->corrections);
        if (step->parameter >= end) return walk;
    }
    walk.points.push_back(curve_at(curve, end).point);
    walk.parameters.push_back(end);
    walk.steps.push_back(0);
    return walk;
}

double speed_fluctuation(const Polyline& points, double chord) {
    double worst = 0;
    for (std::size_t i = 2; i < points.size(); ++i)
        worst = std::max(worst, std::abs(1 - distance(points[i - 2], points[i - 1]) / chord));
    return worst;
}

}  // namespace bead
