#include "fem/plane_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/expects.h"
#include "numeric/frontal_cholesky.h"
#include "numeric/product.h"

namespace bead {
namespace {

ElementPattern pattern_of(const PlaneMesh& mesh) {
    ElementPattern pattern{2, nodes_of(mesh.kind), {}, mesh.elements};
    for (const Vec2 p : mesh.nodes) pattern.places.push_back({float(p.x), float(p.y), 0});
    return pattern;
}

std::array<double, 2 * most_nodes> values_of(std::span<const int> nodes,
                                             std::span<const double> all) {
    std::array<double, 2 * most_nodes> values{};
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        values[2 * a] = all[2 * std::size_t(nodes[a])];
        values[2 * a + 1] = all[2 * std::size_t(nodes[a]) + 1];
    }
    return values;
}

}  // namespace

struct PlaneSolver::Factor {
    PlaneMesh mesh;
    PlaneLaw law;
    std::vector<std::uint8_t> held;
    FrontalCholesky cholesky;
};

PlaneSolver::PlaneSolver(PlaneMesh mesh, const PlaneLaw& law, double thickness,
                         std::vector<std::uint8_t> held) {
    BEAD_EXPECTS(held.size() == 2 * mesh.nodes.size());
    const PlaneLaw thick = thickness * law;
    const ElementMatrix matrix = [&](std::size_t e, std::span<double> values) {
        stiffness(mesh.kind, mesh.places(e), thick, values);
    };
    FrontalCholesky cholesky(elimination_tree(pattern_of(mesh)), matrix, held);
    factor_ = std::make_unique<Factor>(
        Factor{std::move(mesh), thick, std::move(held), std::move(cholesky)});
}

PlaneSolver::PlaneSolver(PlaneSolver&&) noexcept = default;
PlaneSolver::~PlaneSolver() = default;

std::optional<std::size_t> PlaneSolver::loose_node() const {
    const std::optional<std::size_t> unknown = factor_->cholesky.singular();
    if (!unknown) return std::nullopt;
    return *unknown / 2;
}

Displacement PlaneSolver::solve(std::span<const double> load) const {
    return solve_moved(load, std::vector<double>(load.size(), 0.0));
}

Displacement PlaneSolver::solve_moved(std::span<const double> load,
                                      std::span<const double> given) const {
    Displacement result;
    const std::vector<double> from_given = forces(given);
    std::vector<double> right(load.begin(), load.end());
    for (std::size_t i = 0; i < right.size(); ++i) right[i] -= from_given[i];
    result.values = factor_->cholesky.solve(right);
    for (std::size_t i = 0; i < given.size(); ++i)
        if (factor_->held[i] != 0) result.values[i] = given[i];
    std::vector<double> error = forces(result.values);
    for (std::size_t i = 0; i < error.size(); ++i)
        error[i] = factor_->held[i] != 0 ? 0 : error[i] - load[i];
    const double size = std::max(product(load, load), product(from_given, from_given));
    result.residual = size > 0 ? std::sqrt(product(error, error) / size) : 0;
    result.converged = result.residual < 1e-6;
    return result;
}

std::vector<double> PlaneSolver::forces(std::span<const double> displacement) const {
    const PlaneMesh& mesh = factor_->mesh;
    std::vector<double> result(displacement.size(), 0.0);
    const std::size_t size = 2 * std::size_t(nodes_of(mesh.kind));
    std::vector<double> matrix(size * size);
    for (std::size_t e = 0; e < mesh.count(); ++e) {
        stiffness(mesh.kind, mesh.places(e), factor_->law, matrix);
        const std::span<const int> nodes = mesh.element(e);
        const auto u = values_of(nodes, displacement);
        for (std::size_t i = 0; i < size; ++i)
            result[2 * std::size_t(nodes[i / 2]) + i % 2] +=
                product(std::span(matrix).subspan(i * size, size), std::span(u).first(size));
    }
    return result;
}

std::vector<double> PlaneSolver::reactions(std::span<const double> load,
                                           std::span<const double> displacement) const {
    std::vector<double> result = forces(displacement);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = factor_->held[i] != 0 ? result[i] - load[i] : 0;
    return result;
}

std::vector<PlaneTensor> node_stress(const PlaneMesh& mesh, const PlaneLaw& law,
                                     std::span<const double> displacement) {
    std::vector<PlaneTensor> stress(mesh.nodes.size());
    std::vector<int> count(mesh.nodes.size(), 0);
    const auto corners = std::size_t(corners_of(mesh.kind));
    for (std::size_t e = 0; e < mesh.count(); ++e) {
        const auto places = mesh.places(e);
        const std::span<const int> nodes = mesh.element(e);
        const auto u = values_of(nodes, displacement);
        const auto points = stress_points(mesh.kind);
        std::array<PlaneTensor, 4> best{};
        for (std::size_t p = 0; p < points.size(); ++p)
            best[p] = stress_of(law, strain(mapped(mesh.kind, points[p].place, places).shapes,
                                            std::span(u).first(2 * nodes.size())));
        // A field that is linear in a triangle, bilinear in a quadrilateral, constant in a Q4,
        // through the best points.
        std::array<PlaneTensor, most_nodes> at{};
        if (mesh.kind == PlaneElement::t6) {
            const PlaneTensor mean = 1.0 / 3 * (best[0] + best[1] + best[2]);
            for (std::size_t a = 0; a < 3; ++a) at[a] = mean + 2.0 * (best[a] - mean);
        } else if (mesh.kind == PlaneElement::q8) {
            constexpr double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
            const double reach = std::sqrt(3.0);
            for (std::size_t a = 0; a < 4; ++a)
                for (std::size_t p = 0; p < 4; ++p) {
                    const double px = p % 2 == 0 ? -1 : 1, py = p < 2 ? -1 : 1;
                    at[a] = at[a] + (1 + reach * px * x[a]) * (1 + reach * py * y[a]) / 4 * best[p];
                }
        } else {
            at.fill(best[0]);
        }
        for (std::size_t a = corners; a < nodes.size(); ++a)
            at[a] = 0.5 * (at[a - corners] + at[(a - corners + 1) % corners]);
        for (std::size_t a = 0; a < nodes.size(); ++a) {
            stress[std::size_t(nodes[a])] = stress[std::size_t(nodes[a])] + at[a];
            ++count[std::size_t(nodes[a])];
        }
    }
    for (std::size_t n = 0; n < stress.size(); ++n)
        if (count[n] > 1) stress[n] = 1.0 / count[n] * stress[n];
    return stress;
}

std::optional<MeshPlace> locate(const PlaneMesh& mesh, Vec2 point) {
    std::optional<MeshPlace> best;
    double least = 0.05;  // of the parent's size
    const bool triangle = mesh.kind == PlaneElement::t6;
    const auto nodes = std::size_t(nodes_of(mesh.kind));
    for (std::size_t e = 0; e < mesh.count(); ++e) {
        const auto at = mesh.places(e);
        const Box2 box = bounds(std::span(at).first(nodes));
        const double slack = 0.1 * length(box.size());
        if (point.x < box.low.x - slack || point.x > box.high.x + slack ||
            point.y < box.low.y - slack || point.y > box.high.y + slack)
            continue;
        Vec2 place = triangle ? Vec2{1.0 / 3, 1.0 / 3} : Vec2{};
        for (int step = 0; step < 12; ++step) {  // Newton
            const Mapped m = mapped(mesh.kind, place, at);
            Vec2 error = point;
            for (std::size_t a = 0; a < nodes; ++a) error = error - m.shapes.value[a] * at[a];
            const Shapes parent = shapes_at(mesh.kind, place);
            Vec2 by_r, by_s;
            for (std::size_t a = 0; a < nodes; ++a) {
                by_r = by_r + parent.slope[a].x * at[a];
                by_s = by_s + parent.slope[a].y * at[a];
            }
            place = place + Vec2{cross(error, by_s), cross(by_r, error)} / m.area;
        }
        const double outside = triangle ? std::max({-place.x, -place.y, place.x + place.y - 1})
                                        : std::max(std::abs(place.x), std::abs(place.y)) - 1;
        if (!(outside < least)) continue;
        least = outside;
        best = {e, place};
        if (outside <= 1e-9) break;
    }
    return best;
}

PlaneTensor stress_at(const PlaneMesh& mesh, std::span<const PlaneTensor> at_nodes,
                      const MeshPlace& place) {
    const Shapes shapes = shapes_at(mesh.kind, place.place);
    const std::span<const int> nodes = mesh.element(place.element);
    PlaneTensor stress;
    for (std::size_t a = 0; a < nodes.size(); ++a)
        stress = stress + shapes.value[a] * at_nodes[std::size_t(nodes[a])];
    return stress;
}

}  // namespace bead
