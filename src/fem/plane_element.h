// Plane elements of any shape: quadrilaterals of four (Q4) and eight nodes (Q8), triangles of six
// (T6), by the isoparametric map. Nodes are corners counter-clockwise, then the middles of the
// sides in the same order (Zienkiewicz and Taylor).
#pragma once
#include <array>
#include <span>
#include <vector>

#include "fem/plane_law.h"

namespace bead {

enum class PlaneElement { q4, q8, t6 };

constexpr int nodes_of(PlaneElement kind) {
    return kind == PlaneElement::q4 ? 4 : kind == PlaneElement::q8 ? 8 : 6;
}
constexpr int corners_of(PlaneElement kind) { return kind == PlaneElement::t6 ? 3 : 4; }

inline constexpr std::size_t most_nodes = 8;

// At a place of the parent: [-1, 1]² for quadrilaterals, x, y >= 0, x + y <= 1 for triangles.
struct Shapes {
    std::array<double, most_nodes> value{};
    std::array<Vec2, most_nodes> slope{};  // by the parent's coordinates
};
Shapes shapes_at(PlaneElement kind, Vec2 place);

struct QuadraturePoint {
    Vec2 place;
    double weight = 0;
};
// 2 x 2 for Q4, 3 x 3 for Q8, seven points (Radon) for T6.
std::span<const QuadraturePoint> quadrature(PlaneElement kind);
// The points at which stress is best (Barlow): one, four, three.
std::span<const QuadraturePoint> stress_points(PlaneElement kind);

// The slopes by x and y at a place, and the map's area factor, which is positive in a good element.
struct Mapped {
    Shapes shapes;  // slopes by x and y
    double area = 0;
};
Mapped mapped(PlaneElement kind, Vec2 place, std::span<const Vec2> nodes);

// (2 n)², row by row, for unit thickness.
void stiffness(PlaneElement kind, std::span<const Vec2> nodes, const PlaneLaw& law,
               std::span<double> matrix);

// Engineering strain of displacements x0 y0 x1 y1 …
PlaneTensor strain(const Shapes& slopes, std::span<const double> displacement);

}  // namespace bead
