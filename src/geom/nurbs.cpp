#include "geom/nurbs.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/expects.h"
#include "geom/deviation.h"

namespace bead {
namespace {

constexpr int highest_degree = 7;
using Values = std::array<double, highest_degree + 1>;
using Controls = std::array<Vec3, highest_degree + 1>;  // (w x, w y, w)

std::size_t degree_of(const Nurbs& curve) { return static_cast<std::size_t>(curve.degree); }

// Index of the knot at which the span of `u` begins.
std::size_t span_of(const Nurbs& curve, double u) {
    const std::size_t p = degree_of(curve), n = curve.points.size();
    const auto first = curve.knots.begin();
    const auto after = std::upper_bound(first + static_cast<std::ptrdiff_t>(p),
                                        first + static_cast<std::ptrdiff_t>(n), u);
    auto span = static_cast<std::size_t>(after - first) - 1;
    while (span > p && curve.knots[span] == curve.knots[span + 1]) --span;  // the right end
    return span;
}

// The `degree` + 1 basis functions that are not 0 in the span.
Values basis(const std::vector<double>& knots, std::size_t span, std::size_t degree, double u) {
    Values values{1};
    for (std::size_t j = 1; j <= degree; ++j) {
        double carried = 0;
        for (std::size_t r = 0; r < j; ++r) {
            const double right = knots[span + r + 1] - u, left = u - knots[span + 1 + r - j];
            const double part = values[r] / (right + left);
            values[r] = carried + right * part;
            carried = left * part;
        }
        values[j] = carried;
    }
    return values;
}

Vec3 weighted_sum(const Values& weights, const Controls& controls, std::size_t count) {
    Vec3 sum;
    for (std::size_t i = 0; i < count; ++i) sum = sum + weights[i] * controls[i];
    return sum;
}

// Control points of the derivative on this span: one fewer, for a curve of degree one lower.
void differentiate(Controls& controls, const std::vector<double>& knots, std::size_t span,
                   std::size_t degree) {
    for (std::size_t i = 0; i < degree; ++i) {
        const double width = knots[span + i + 1] - knots[span + i + 1 - degree];
        controls[i] = (static_cast<double>(degree) / width) * (controls[i + 1] - controls[i]);
    }
}

void halve(const Nurbs& curve, double tolerance, double from, double to, int depth,
           Polyline& points) {
    const Vec2 a = points.back(), b = curve_at(curve, to).point;
    double off = 0;
    for (const double part : {0.25, 0.5, 0.75}) {
        const Vec2 p = curve_at(curve, std::lerp(from, to, part)).point;
        off = std::max(off, segment_distance(a, b, p));
    }
    if (off <= tolerance || depth == 0) {
        points.push_back(b);
        return;
    }
    const double middle = std::midpoint(from, to);
    halve(curve, tolerance, from, middle, depth - 1, points);
    halve(curve, tolerance, middle, to, depth - 1, points);
}

}  // namespace

bool is_curve(const Nurbs& curve) {
    const std::size_t n = curve.points.size();
    return curve.degree >= 1 && curve.degree <= highest_degree && n > degree_of(curve) &&
           curve.weights.size() == n && curve.knots.size() == n + degree_of(curve) + 1 &&
           std::is_sorted(curve.knots.begin(), curve.knots.end()) &&
           first_parameter(curve) < last_parameter(curve) &&
           std::all_of(curve.weights.begin(), curve.weights.end(), [](double w) { return w > 0; });
}

double first_parameter(const Nurbs& curve) { return curve.knots[degree_of(curve)]; }
double last_parameter(const Nurbs& curve) { return curve.knots[curve.points.size()]; }

CurvePlace curve_at(const Nurbs& curve, double parameter) {
    const std::size_t p = degree_of(curve);
    BEAD_EXPECTS(curve.degree >= 1 && curve.degree <= highest_degree);
    BEAD_EXPECTS(curve.knots.size() == curve.points.size() + p + 1);
    const double u = std::clamp(parameter, first_parameter(curve), last_parameter(curve));
    const std::size_t span = span_of(curve, u);
    Controls controls;
    for (std::size_t i = 0; i <= p; ++i) {
        const double w = curve.weights[span - p + i];
        controls[i] = at_height(w * curve.points[span - p + i], w);
    }
    const Vec3 a = weighted_sum(basis(curve.knots, span, p, u), controls, p + 1);
    differentiate(controls, curve.knots, span, p);
    const Vec3 a1 = weighted_sum(basis(curve.knots, span, p - 1, u), controls, p);
    Vec3 a2;
    if (p >= 2) {
        differentiate(controls, curve.knots, span, p - 1);
        a2 = weighted_sum(basis(curve.knots, span, p - 2, u), controls, p - 1);
    }
    const Vec2 point = flat(a) / a.z;
    const Vec2 first = (flat(a1) - a1.z * point) / a.z;
    return {point, first, (flat(a2) - 2 * a1.z * first - a2.z * point) / a.z};
}

double curvature(const CurvePlace& place) {
    const double speed = length(place.first);
    return speed > 0 ? cross(place.first, place.second) / (speed * speed * speed) : 0;
}

double peak_curvature(const Nurbs& curve, int samples) {
    double peak = 0;
    for (std::size_t i = degree_of(curve); i < curve.points.size(); ++i)
        for (int k = 0; k <= samples && curve.knots[i] < curve.knots[i + 1]; ++k) {
            const double part = static_cast<double>(k) / samples;
            const double u = std::lerp(curve.knots[i], curve.knots[i + 1], part);
            peak = std::max(peak, std::abs(curvature(curve_at(curve, u))));
        }
    return peak;
}

Polyline flattened(const Nurbs& curve, double tolerance) {
    BEAD_EXPECTS(tolerance > 0);
    constexpr int most_halvings = 16, first_parts = 4;  // a span may be an S: never its chord alone
    Polyline points{curve_at(curve, first_parameter(curve)).point};
    for (std::size_t i = degree_of(curve); i < curve.points.size(); ++i)
        for (int k = 0; k < first_parts && curve.knots[i] < curve.knots[i + 1]; ++k) {
            const auto knot = [&](int part) {
                return std::lerp(curve.knots[i], curve.knots[i + 1], 1.0 * part / first_parts);
            };
            halve(curve, tolerance, knot(k), knot(k + 1), most_halvings, points);
        }
    return points;
}

Nurbs nurbs_of(const PlanarArc& arc) {
    const int quarters = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / (pi / 2))));
    const double half = arc.sweep / (2 * quarters);
    Nurbs curve{2, {0, 0, 0}, {point_at(arc, 0)}, {1}};
    for (int i = 1; i <= quarters; ++i) {
        const double to = arc.start + 2 * i * half;
        curve.points.push_back(arc.centre + (arc.radius / std::cos(half)) * unit(to - half));
        curve.points.push_back(arc.centre + arc.radius * unit(to));
        curve.weights.insert(curve.weights.end(), {std::cos(half), 1.0});
        const double knot = static_cast<double>(i) / quarters;
        curve.knots.insert(curve.knots.end(), i < quarters ? 2 : 3, knot);
    }
    return curve;
}

Nurbs bezier(Polyline points) {
    const std::size_t n = points.size();
    BEAD_EXPECTS(n >= 2 && n <= highest_degree + 1);
    Nurbs curve{static_cast<int>(n) - 1, std::vector<double>(n, 0.0), std::move(points),
                std::vector<double>(n, 1.0)};
    curve.knots.insert(curve.knots.end(), n, 1.0);
    return curve;
}

}  // namespace bead
