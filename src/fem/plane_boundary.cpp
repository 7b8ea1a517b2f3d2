// Loads and supports on the sides of a mesh; declared in fem/plane_solver.h.
#include <algorithm>
#include <cmath>

#include "fem/plane_solver.h"
#include "fem/stretch.h"
#include "geom/along.h"

namespace bead {
namespace {

// Of a side's length: where a stretch ends beside a corner, one point stands for both.
constexpr double slack_share = 0.05;

bool within(const BoundarySpan& span, const MeshSide& side, double around) {
    if (side.loop != span.loop) return false;
    const double slack = slack_share * (side.to - side.from);
    for (const double turn : {0.0, around})
        if (side.from + turn >= span.from - slack && side.to + turn <= span.to + slack) return true;
    return false;
}

struct SidePoint {
    std::array<double, 3> share{};  // of begin, end, middle
    Vec2 place;
    double length = 0;  // mm, weighted
};

// Three Gauss points along a side, straight or curved.
std::array<SidePoint, 3> points_on(const PlaneMesh& mesh, const MeshSide& side) {
    const Vec2 a = mesh.nodes[std::size_t(side.begin)], b = mesh.nodes[std::size_t(side.end)];
    const Vec2 m = side.middle < 0 ? lerp(a, b, 0.5) : mesh.nodes[std::size_t(side.middle)];
    constexpr double weight[] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    std::array<SidePoint, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
        const double t = (double(k) - 1) * std::sqrt(0.6);
        const Vec2 slope = (t - 0.5) * a + (t + 0.5) * b - 2 * t * m;
        const std::array<double, 3> square{t * (t - 1) / 2, t * (t + 1) / 2, 1 - t * t};
        points[k].place = square[0] * a + square[1] * b + square[2] * m;
        points[k].length = weight[k] * length(slope);
        points[k].share = side.middle < 0 ? std::array{(1 - t) / 2, (1 + t) / 2, 0.0} : square;
    }
    return points;
}

std::vector<MeshSide> sides_on(const PlaneMesh& mesh, const std::vector<MeasuredLoop>& loops,
                               const std::vector<BoundarySpan>& spans) {
    std::vector<MeshSide> found;
    for (const MeshSide& side : mesh.sides)
        if (std::ranges::any_of(spans, [&](const BoundarySpan& span) {
                return within(span, side, loops[span.loop].length);
            }))
            found.push_back(side);
    return found;
}

bool add_load(const PlaneMesh& mesh, const std::vector<MeshSide>& sides, const Load& load,
              std::vector<double>& result) {
    double total = 0;
    for (const MeshSide& side : sides)
        for (const SidePoint& point : points_on(mesh, side))
            total += point.length * traction(load, point.place);
    if (!(total > 0)) return false;
    for (const MeshSide& side : sides)
        for (const SidePoint& point : points_on(mesh, side)) {
            const Vec2 force = point.length * traction(load, point.place) / total * load.force;
            const std::array nodes{side.begin, side.end, side.middle};
            for (std::size_t k = 0; k < 3; ++k) {
                if (nodes[k] < 0) continue;
                result[2 * std::size_t(nodes[k])] += point.share[k] * force.x;
                result[2 * std::size_t(nodes[k]) + 1] += point.share[k] * force.y;
            }
        }
    return true;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> held_nodes(const PlaneMesh& mesh, const Region& part,
                                                    const std::vector<Support>& supports) {
    const std::vector<MeasuredLoop> loops = measured_loops(part);
    std::vector<std::uint8_t> held(2 * mesh.nodes.size(), 0);
    const auto hold = [&](const Support& support, int node) {
        if (node < 0) return;
        if (support.x) held[2 * std::size_t(node)] = 1;
        if (support.y) held[2 * std::size_t(node) + 1] = 1;
    };
    for (const Support& support : supports) {
        const auto spans = stretch_spans(part, support.on);
        if (!spans) return std::nullopt;
        for (const MeshSide& side : sides_on(mesh, loops, *spans))
            for (const int node : {side.begin, side.end, side.middle}) hold(support, node);
        for (const BoundarySpan& span : *spans) {
            if (span.to > span.from) continue;
            const Vec2 place = point_at(loops[span.loop], span.from);
            hold(support, int(std::ranges::min_element(mesh.nodes, {},
                                                       [&](Vec2 p) { return distance(p, place); }) -
                              mesh.nodes.begin()));
        }
    }
    return held;
}

std::optional<std::vector<double>> load_vector(const PlaneMesh& mesh, const Region& part,
                                               const std::vector<Load>& loads) {
    const std::vector<MeasuredLoop> loops = measured_loops(part);
    std::vector<double> result(2 * mesh.nodes.size(), 0.0);
    for (const Load& load : loads) {
        const auto spans = stretch_spans(part, load.on);
        if (!spans || !add_load(mesh, sides_on(mesh, loops, *spans), load, result))
            return std::nullopt;
    }
    return result;
}

}  // namespace bead
