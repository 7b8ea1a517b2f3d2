#include "fem/plane_element.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

constexpr std::array<Vec2, 4> square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

Shapes q4(Vec2 p) {
    Shapes s;
    for (std::size_t c = 0; c < 4; ++c) {
        const double x = 1 + square[c].x * p.x, y = 1 + square[c].y * p.y;
        s.value[c] = x * y / 4;
        s.slope[c] = {square[c].x * y / 4, square[c].y * x / 4};
    }
    return s;
}

// Serendipity: corners (1 + x)(1 + y)(x + y - 1)/4, middles (1 - x²)(1 + y)/2.
Shapes q8(Vec2 p) {
    Shapes s;
    for (std::size_t c = 0; c < 4; ++c) {
        const double cx = square[c].x, cy = square[c].y, x = cx * p.x, y = cy * p.y;
        s.value[c] = (1 + x) * (1 + y) * (x + y - 1) / 4;
        s.slope[c] = {cx * (1 + y) * (2 * x + y) / 4, cy * (1 + x) * (x + 2 * y) / 4};
    }
    for (const std::size_t c : {0U, 2U}) {  // sides along x
        const double cy = square[c].y;
        s.value[4 + c] = (1 - p.x * p.x) * (1 + cy * p.y) / 2;
        s.slope[4 + c] = {-p.x * (1 + cy * p.y), cy * (1 - p.x * p.x) / 2};
    }
    for (const std::size_t c : {1U, 3U}) {
        const double cx = square[c].x;
        s.value[4 + c] = (1 + cx * p.x) * (1 - p.y * p.y) / 2;
        s.slope[4 + c] = {cx * (1 - p.y * p.y) / 2, -p.y * (1 + cx * p.x)};
    }
    return s;
}

Shapes t6(Vec2 p) {
    Shapes s;
    const std::array<double, 3> l{1 - p.x - p.y, p.x, p.y};
    constexpr std::array<Vec2, 3> d{{{-1, -1}, {1, 0}, {0, 1}}};
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3;
        s.value[a] = l[a] * (2 * l[a] - 1);
        s.slope[a] = (4 * l[a] - 1) * d[a];
        s.value[3 + a] = 4 * l[a] * l[b];
        s.slope[3 + a] = 4 * l[b] * d[a] + 4 * l[a] * d[b];
    }
    return s;
}

std::vector<QuadraturePoint> gauss_square(std::initializer_list<std::pair<double, double>> rule) {
    std::vector<QuadraturePoint> points;
    for (const auto& [y, wy] : rule)
        for (const auto& [x, wx] : rule) points.push_back({{x, y}, wx * wy});
    return points;
}

std::vector<QuadraturePoint> radon() {
    const double r = std::sqrt(15.0);
    std::vector<QuadraturePoint> points{{{1.0 / 3, 1.0 / 3}, 9.0 / 80}};
    for (const double sign : {1.0, -1.0}) {
        const double a = (6 + sign * r) / 21, w = (155 + sign * r) / 2400;
        for (const Vec2 p : {Vec2{a, a}, Vec2{1 - 2 * a, a}, Vec2{a, 1 - 2 * a}})
            points.push_back({p, w});
    }
    return points;
}

}  // namespace

Shapes shapes_at(PlaneElement kind, Vec2 place) {
    if (kind == PlaneElement::q4) return q4(place);
    return kind == PlaneElement::q8 ? q8(place) : t6(place);
}

std::span<const QuadraturePoint> quadrature(PlaneElement kind) {
    static const double g2 = 1 / std::sqrt(3.0), g3 = std::sqrt(0.6);
    static const std::vector<QuadraturePoint> two = gauss_square({{-g2, 1}, {g2, 1}});
    static const std::vector<QuadraturePoint> three =
        gauss_square({{-g3, 5.0 / 9}, {0, 8.0 / 9}, {g3, 5.0 / 9}});
    static const std::vector<QuadraturePoint> seven = radon();
    if (kind == PlaneElement::q4) return two;
    return kind == PlaneElement::q8 ? three : seven;
}

std::span<const QuadraturePoint> stress_points(PlaneElement kind) {
    static const std::vector<QuadraturePoint> one{{{0, 0}, 4}};
    static const std::vector<QuadraturePoint> three{{{1.0 / 6, 1.0 / 6}, 1.0 / 6},
                                                    {{2.0 / 3, 1.0 / 6}, 1.0 / 6},
                                                    {{1.0 / 6, 2.0 / 3}, 1.0 / 6}};
    if (kind == PlaneElement::q4) return one;
    return kind == PlaneElement::q8 ? quadrature(PlaneElement::q4)
                                    : std::span<const QuadraturePoint>(three);
}

Mapped mapped(PlaneElement kind, Vec2 place, std::span<const Vec2> nodes) {
    Mapped m{shapes_at(kind, place), 0};
    Vec2 by_r, by_s;
    const auto count = std::size_t(nodes_of(kind));
    for (std::size_t a = 0; a < count; ++a) {
        by_r = by_r + m.shapes.slope[a].x * nodes[a];
        by_s = by_s + m.shapes.slope[a].y * nodes[a];
    }
    m.area = cross(by_r, by_s);
    for (std::size_t a = 0; a < count; ++a) {
        const Vec2 d = m.shapes.slope[a];
        m.shapes.slope[a] = {(d.x * by_s.y - d.y * by_r.y) / m.area,
                             (d.y * by_r.x - d.x * by_s.x) / m.area};
    }
    return m;
}

void stiffness(PlaneElement kind, std::span<const Vec2> nodes, const PlaneLaw& law,
               std::span<double> matrix) {
    const auto count = std::size_t(nodes_of(kind));
    std::ranges::fill(matrix, 0.0);
    for (const QuadraturePoint& point : quadrature(kind)) {
        const Mapped m = mapped(kind, point.place, nodes);
        const double weight = point.weight * m.area;
        for (std::size_t b = 0; b < count; ++b) {
            const Vec2 d = m.shapes.slope[b];
            const PlaneTensor from_x = weight * stress_of(law, {d.x, 0, d.y});
            const PlaneTensor from_y = weight * stress_of(law, {0, d.y, d.x});
            for (std::size_t a = 0; a < count; ++a) {
                const Vec2 e = m.shapes.slope[a];
                double* row = &matrix[2 * a * 2 * count + 2 * b];
                row[0] += e.x * from_x.xx + e.y * from_x.xy;
                row[1] += e.x * from_y.xx + e.y * from_y.xy;
                row[2 * count] += e.y * from_x.yy + e.x * from_x.xy;
                row[2 * count + 1] += e.y * from_y.yy + e.x * from_y.xy;
            }
        }
    }
}

PlaneTensor strain(const Shapes& slopes, std::span<const double> displacement) {
    PlaneTensor e;
    for (std::size_t a = 0; 2 * a < displacement.size(); ++a) {
        const Vec2 d = slopes.slope[a];
        e.xx += d.x * displacement[2 * a];
        e.yy += d.y * displacement[2 * a + 1];
        e.xy += d.y * displacement[2 * a] + d.x * displacement[2 * a + 1];
    }
    return e;
}

}  // namespace bead
