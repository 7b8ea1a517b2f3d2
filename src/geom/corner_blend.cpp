#include "geom/corner_blend.h"

#include <algorithm>

#include "core/expects.h"

namespace bead {
namespace {

struct Legs {
    Vec2 in, out;     // unit vectors, in the direction of travel
    double turn = 0;  // rad, above 0
    bool left = false;
};

std::optional<Legs> legs_of(Vec2 before, Vec2 corner, Vec2 after) {
    constexpr double least = 0.01 * pi / 180, most = 179 * pi / 180;
    const double first = distance(before, corner), second = distance(corner, after);
    if (first <= 0 || second <= 0) return std::nullopt;
    const Vec2 in = (corner - before) / first, out = (after - corner) / second;
    const double turn = std::atan2(std::abs(cross(in, out)), dot(in, out));
    if (turn < least || turn > most) return std::nullopt;
    return Legs{in, out, turn, cross(in, out) > 0};
}

// The k of least peak curvature, found by search for turns of 1° to 178° and fitted in cos(θ/2).
double spread(double turn) {
    const double c = std::cos(turn / 2);
    return c / (1 + c * (2.012 + c * (-0.4365 + 0.159 * c)));
}

struct Derivatives {
    std::array<Vec2, 5> first;
    std::array<Vec2, 4> second;
};

Derivatives derivatives_of(const CornerBlend& blend) {
    Derivatives d;
    for (std::size_t i = 0; i < 5; ++i) d.first[i] = 5 * (blend.points[i + 1] - blend.points[i]);
    for (std::size_t i = 0; i < 4; ++i) d.second[i] = 4 * (d.first[i + 1] - d.first[i]);
    return d;
}

// De Casteljau's halving of the way between the points.
template <std::size_t N>
Vec2 on_curve(std::array<Vec2, N> points, double part) {
    for (std::size_t n = N - 1; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i) points[i] = lerp(points[i], points[i + 1], part);
    return points[0];
}

double curvature_at(const Derivatives& d, double part) {
    const Vec2 first = on_curve(d.first, part);
    const double speed = length(first);
    return std::abs(cross(first, on_curve(d.second, part))) / (speed * speed * speed);
}

}  // namespace

std::optional<CornerBlend> corner_blend(Vec2 before, Vec2 corner, Vec2 after,
                                        const BlendOptions& options) {
    BEAD_EXPECTS(options.deviation > 0 && options.longest_leg > 0);
    const auto legs = legs_of(before, corner, after);
    if (!legs) return std::nullopt;
    const double k = spread(legs->turn);
    const double passes = (16 - 25 * k) / 16 * std::sin(legs->turn / 2);  // per mm of leg
    const double leg = std::min(options.deviation / passes, options.longest_leg);
    CornerBlend blend{{}, leg, leg * passes};
    for (std::size_t i = 0; i < 3; ++i) {
        const double reach = leg * (1 - static_cast<double>(i) * k);
        blend.points[i] = corner - reach * legs->in;
        blend.points[5 - i] = corner + reach * legs->out;
    }
    return blend;
}

Vec2 point_at(const CornerBlend& blend, double part) { return on_curve(blend.points, part); }

// Gauss's rule of five points on each of eight pieces.
double length(const CornerBlend& blend) {
    constexpr std::array nodes{0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array weights{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    constexpr int pieces = 8;
    const Derivatives d = derivatives_of(blend);
    double sum = 0;
    for (int piece = 0; piece < pieces; ++piece)
        for (std::size_t i = 0; i < 3; ++i)
            for (const double side : {-0.5, 0.5}) {
                const double part = (piece + 0.5 + side * nodes[i]) / pieces;
                sum += (i == 0 ? 0.5 : 1.0) * weights[i] * length(on_curve(d.first, part));
            }
    return sum / (2 * pieces);
}

// The best of a row of places, then of the places between its neighbours: the two halves mirror
// each other, so one will do.
double peak_curvature(const CornerBlend& blend) {
    const Derivatives d = derivatives_of(blend);
    double low = 0, high = 0.5, peak = 0;
    for (int round = 0; round < 4; ++round) {
        constexpr int places = 8;
        const double step = (high - low) / places;
        double best = low;
        for (int i = 0; i <= places; ++i) {
            const double here = curvature_at(d, low + i * step);
            if (here <= peak) continue;
            peak = here;
            best = low + i * step;
        }
        low = std::max(best - step, 0.0);
        high = std::min(best + step, 0.5);
    }
    return peak;
}

Nurbs nurbs_of(const CornerBlend& blend) {
    return bezier({blend.points.begin(), blend.points.end()});
}

std::optional<ArcBlend> arc_blend(Vec2 before, Vec2 corner, Vec2 after,
                                  const BlendOptions& options) {
    BEAD_EXPECTS(options.deviation > 0 && options.longest_leg > 0);
    const auto legs = legs_of(before, corner, after);
    if (!legs) return std::nullopt;
    const double half = legs->turn / 2, side = legs->left ? 1 : -1;
    const double passes = std::tan(half / 2);  // mm of deviation per mm of leg
    const double leg = std::min(options.deviation / passes, options.longest_leg);
    const double radius = leg / std::tan(half);
    const Vec2 to_centre = side * left_of(legs->in);
    const Vec2 centre = corner - leg * legs->in + radius * to_centre;
    return ArcBlend{{centre, radius, std::atan2(-to_centre.y, -to_centre.x), side * legs->turn},
                    leg,
                    leg * passes};
}

}  // namespace bead
