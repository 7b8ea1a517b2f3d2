#include "geom/cubic_spline.h"

#include <algorithm>

#include "core/expects.h"

namespace bead {
namespace {

double turn_at(Vec2 before, Vec2 here, Vec2 after) {
    const Vec2 in = here - before, out = after - here;
    return std::atan2(std::abs(cross(in, out)), dot(in, out));
}

// Of each chord, as an arc over the mean of the turns at its ends.
std::vector<double> arc_lengths(const Polyline& points, double first_turn, double last_turn) {
    const std::size_t n = points.size();
    std::vector<double> turns(n), lengths;
    for (std::size_t i = 1; i + 1 < n; ++i)
        turns[i] = turn_at(points[i - 1], points[i], points[i + 1]);
    turns[0] = first_turn;
    turns[n - 1] = last_turn;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const double half = std::min((turns[i] + turns[i + 1]) / 4, 1.0);
        const double chord = distance(points[i], points[i + 1]);
        BEAD_EXPECTS(chord > 0);
        lengths.push_back(half > 1e-6 ? chord * half / std::sin(half) : chord);
    }
    return lengths;
}

// Derivatives at the points, by elimination: h_i m_(i-1) + 2 (h_(i-1) + h_i) m_i + h_(i-1) m_(i+1)
// = 3 (h_i d_(i-1) + h_(i-1) d_i), d being the slopes of the chords.
Polyline slopes(const Polyline& points, const std::vector<double>& lengths, Vec2 first, Vec2 last) {
    const std::size_t n = points.size();
    Polyline m(n);
    std::vector<double> above(n, 0);
    m[0] = first;
    m[n - 1] = last;
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double a = lengths[i - 1], b = lengths[i];
        const Vec2 right =
            (3 * b / a) * (points[i] - points[i - 1]) + (3 * a / b) * (points[i + 1] - points[i]);
        const double pivot = 2 * (a + b) - b * above[i - 1];
        above[i] = a / pivot;
        m[i] = (right - b * m[i - 1]) / pivot;
    }
    for (std::size_t i = n - 2; i > 0; --i) m[i] = m[i] - above[i] * m[i + 1];
    return m;
}

// Bézier pieces under one knot vector with every inner knot twice.
Nurbs joined(const Polyline& points, const Polyline& slope, const std::vector<double>& lengths) {
    Nurbs curve{3, std::vector<double>(4, 0.0), {points[0]}, {}};
    double knot = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double third = lengths[i] / 3;
        curve.points.push_back(points[i] + third * slope[i]);
        curve.points.push_back(points[i + 1] - third * slope[i + 1]);
        knot += lengths[i];
        curve.knots.insert(curve.knots.end(), i + 2 < points.size() ? 2 : 4, knot);
    }
    curve.points.push_back(points.back());
    curve.weights.assign(curve.points.size(), 1.0);
    return curve;
}

}  // namespace

Nurbs cubic_through(const Polyline& points, Vec2 first, Vec2 last) {
    const std::size_t n = points.size();
    BEAD_EXPECTS(n >= 2);
    const Vec2 begin = points[1] - points[0], end = points[n - 1] - points[n - 2];
    // From the tangent to the first chord it turns by half of what it turns over the chord.
    const double first_turn = 2 * std::atan2(std::abs(cross(first, begin)), dot(first, begin));
    const double last_turn = 2 * std::atan2(std::abs(cross(end, last)), dot(end, last));
    const std::vector<double> lengths = arc_lengths(points, first_turn, last_turn);
    return joined(points, slopes(points, lengths, first, last), lengths);
}

// The loop once round with some of it before and after: what lies that far away does not matter,
// its influence falls to about a quarter from point to point.
Nurbs closed_cubic_through(const Polyline& loop) {
    constexpr std::size_t extra = 24;
    const std::size_t n = loop.size();
    BEAD_EXPECTS(n >= 3);
    Polyline points;
    for (std::size_t i = 0; i <= n + 2 * extra; ++i)
        points.push_back(loop[(i + n * extra - extra) % n]);
    const std::size_t m = points.size();
    const std::vector<double> lengths =
        arc_lengths(points, turn_at(loop[(n * extra - extra - 1) % n], points[0], points[1]),
                    turn_at(points[m - 2], points[m - 1], loop[(n * extra + extra + 1) % n]));
    const Polyline slope =
        slopes(points, lengths, circle_start_direction(points[0], points[1], points[2]),
               -circle_start_direction(points[m - 1], points[m - 2], points[m - 3]));
    const auto part = [&](const auto& whole, std::size_t count) {
        const auto from = whole.begin() + static_cast<std::ptrdiff_t>(extra);
        return std::vector(from, from + static_cast<std::ptrdiff_t>(count));
    };
    return joined(part(points, n + 1), part(slope, n + 1), part(lengths, n));
}

Cubic cubic_of(const Nurbs& curve, const Polyline& points, std::size_t i) {
    return {points[i], curve.points[1 + 2 * i], curve.points[2 + 2 * i], points[i + 1]};
}

Vec2 point_at(const Cubic& c, double t) {
    const double s = 1 - t;
    return (s * s * s) * c[0] + (3 * s * s * t) * c[1] + (3 * s * t * t) * c[2] +
           (t * t * t) * c[3];
}

// Turned inside out about `here` the circle is a line through the images of the other two points,
// and its direction is the circle's.
Vec2 circle_direction(Vec2 before, Vec2 here, Vec2 after) {
    const Vec2 in = here - before, out = after - here;
    const Vec2 along = in / dot(in, in) + out / dot(out, out);
    return along / length(along);
}

Vec2 circle_start_direction(Vec2 here, Vec2 next, Vec2 last) {
    const Vec2 near = next - here, far = last - here;
    const Vec2 along = near / dot(near, near) - far / dot(far, far);
    return along / length(along);
}

}  // namespace bead
