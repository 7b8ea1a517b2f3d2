#define EIGEN_MPL2_ONLY
#include "geom/curve_fit.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>

#include "core/expects.h"

namespace bead {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

std::vector<double> centripetal(const Polyline& points) {
    std::vector<double> at{0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        BEAD_EXPECTS(points[i] != points[i - 1]);
        at.push_back(at.back() + std::sqrt(distance(points[i - 1], points[i])));
    }
    for (double& u : at) u /= at.back();
    at.back() = 1;
    return at;
}

Nurbs empty_curve(const std::vector<double>& inner) {
    Nurbs curve{3, {0, 0, 0, 0}, {}, {}};
    curve.knots.insert(curve.knots.end(), inner.begin(), inner.end());
    curve.knots.insert(curve.knots.end(), 4, 1.0);
    curve.points.resize(inner.size() + 4);
    curve.weights.assign(inner.size() + 4, 1.0);
    return curve;
}

// How much each of the four control points of the span counts at `u`.
std::array<double, 4> shares(const Nurbs& curve, std::size_t span, double u) {
    std::array<double, 4> share{1};
    for (std::size_t j = 1; j < 4; ++j) {
        double carried = 0;
        for (std::size_t r = 0; r < j; ++r) {
            const double right = curve.knots[span + r + 1] - u;
            const double left = u - curve.knots[span + 1 + r - j];
            const double part = share[r] / (right + left);
            share[r] = carried + right * part;
            carried = left * part;
        }
        share[j] = carried;
    }
    return share;
}

std::size_t cubic_span(const Nurbs& curve, double u) {
    const auto after = std::upper_bound(curve.knots.begin() + 4, curve.knots.end() - 4, u);
    return static_cast<std::size_t>(after - curve.knots.begin()) - 1;
}

// The ends are given; the other control points are what makes the squares least.
bool solve(Nurbs& curve, const Polyline& points, const std::vector<double>& at) {
    const auto free = static_cast<Eigen::Index>(curve.points.size()) - 2;
    curve.points.front() = points.front();
    curve.points.back() = points.back();
    std::vector<Eigen::Triplet<double>> products;
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(free, 2);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const std::size_t span = cubic_span(curve, at[i]);
        const std::array<double, 4> share = shares(curve, span, at[i]);
        const auto column = [&](std::size_t k) {
            return static_cast<Eigen::Index>(span - 3 + k) - 1;
        };
        Vec2 rest = points[i];
        for (std::size_t k = 0; k < 4; ++k) {
            if (column(k) < 0) rest = rest - share[k] * points.front();
            if (column(k) >= free) rest = rest - share[k] * points.back();
        }
        for (std::size_t k = 0; k < 4; ++k) {
            if (column(k) < 0 || column(k) >= free) continue;
            right(column(k), 0) += share[k] * rest.x;
            right(column(k), 1) += share[k] * rest.y;
            for (std::size_t j = 0; j < 4; ++j)
                if (column(j) >= 0 && column(j) < free)
                    products.emplace_back(column(k), column(j), share[k] * share[j]);
        }
    }
    Matrix normal(free, free);
    normal.setFromTriplets(products.begin(), products.end());
    const Eigen::SimplicialLDLT<Matrix> factors(normal);
    if (factors.info() != Eigen::Success) return false;
    const Eigen::MatrixX2d solution = factors.solve(right);
    for (Eigen::Index i = 0; i < free; ++i)
        curve.points[static_cast<std::size_t>(i) + 1] = {solution(i, 0), solution(i, 1)};
    return solution.allFinite();
}

// In every span where a point strays by more than the tolerance and that holds two points on each
// side of its middle point, a knot beside that point.
std::vector<double> further_knots(const Nurbs& curve, const std::vector<double>& at,
                                  const std::vector<double>& off, double tolerance) {
    std::vector<double> knots(curve.knots.begin() + 4, curve.knots.end() - 4);
    std::size_t first = 0;
    for (std::size_t span = 3; span < curve.points.size(); ++span) {
        std::size_t last = first;
        double worst = 0;
        while (last < at.size() &&
               (at[last] < curve.knots[span + 1] || span + 1 == curve.points.size()))
            worst = std::max(worst, off[last++]);
        const std::size_t middle = (first + last) / 2;
        if (worst > tolerance && last - first >= 2)
            knots.push_back(0.5 * (at[middle - 1] + at[middle]));
        first = last;
    }
    std::ranges::sort(knots);
    return knots;
}

}  // namespace

std::optional<CurveFit> fitted_curve(const Polyline& points, double tolerance) {
    BEAD_EXPECTS(points.size() >= 4 && tolerance > 0);
    const std::vector<double> at = centripetal(points);
    std::vector<double> inner;
    for (;;) {
        CurveFit fit{empty_curve(inner), 0};
        if (fit.curve.points.size() > points.size() || !solve(fit.curve, points, at))
            return std::nullopt;
        std::vector<double> off;
        for (std::size_t i = 0; i < points.size(); ++i)
            off.push_back(distance(points[i], curve_at(fit.curve, at[i]).point));
        fit.deviation = *std::ranges::max_element(off);
        if (fit.deviation <= tolerance) return fit;
        std::vector<double> more = further_knots(fit.curve, at, off, tolerance);
        if (more.size() == inner.size()) return std::nullopt;
        inner = std::move(more);
    }
}

}  // namespace bead
