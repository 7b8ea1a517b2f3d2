#include "fem/pixel_solver.h"

#include <cmath>

#include "core/expects.h"
#include "fem/pixel_element.h"
#include "fem/solid_numbering.h"
#include "numeric/conjugate_gradients.h"
#include "numeric/frontal_cholesky.h"

namespace bead {
namespace {

ElementPattern pattern_of(const PixelModel& model, const SolidNumbering& numbering) {
    ElementPattern pattern;
    for (const std::size_t node : numbering.nodes) {
        const Vec2 place = model.grid.place(node);
        pattern.places.push_back({float(place.x), float(place.y), 0});
    }
    for (const std::size_t pixel : numbering.pixels)
        for (const std::size_t node : model.grid.corners(pixel))
            pattern.points.push_back(numbering.point_of[node]);
    return pattern;
}

FrontalCholesky factored(const PixelModel& model, const Held& held,
                         const SolidNumbering& numbering) {
    const auto unit_matrix = square_stiffness(model.law);
    const ElementMatrix matrix = [&](std::size_t element, std::span<double> values) {
        const std::size_t pixel = numbering.pixels[element];
        const double factor = model.thickness * model.factor[pixel];
        const auto& unit_thick =
            model.laws.empty() ? unit_matrix : square_stiffness(model.laws[pixel]);
        for (std::size_t i = 0; i < 64; ++i) values[i] = factor * unit_thick[i];
    };
    std::vector<std::uint8_t> held_points;
    for (const std::size_t node : numbering.nodes) {
        held_points.push_back(held[2 * node]);
        held_points.push_back(held[2 * node + 1]);
    }
    return {elimination_tree(pattern_of(model, numbering)), matrix, held_points};
}

void zero_held(const Held& held, std::vector<double>& values) {
    for (std::size_t i = 0; i < held.size(); ++i)
        if (held[i] != 0) values[i] = 0;
}

std::vector<double> diagonal(const PixelModel& model) {
    std::vector<double> sums(2 * model.grid.nodes(), 0.0);
    for (std::size_t pixel = 0; pixel < model.factor.size(); ++pixel) {
        if (model.factor[pixel] == 0) continue;
        const PlaneLaw law = model.thickness * law_of(model, pixel);
        const auto corners = model.grid.corners(pixel);
        for (const std::size_t node : corners) {
            sums[2 * node] += (law.xx + law.ss) / 3;
            sums[2 * node + 1] += (law.yy + law.ss) / 3;
        }
    }
    return sums;
}

}  // namespace

struct PixelSolver::Factor {
    PixelModel model;
    Held held;
    SolidNumbering numbering;
    FrontalCholesky cholesky;

    // K^-1 of the factor, on vectors over all nodes; 0 where it has no unknown.
    [[nodiscard]] std::vector<double> applied(std::span<const double> load) const {
        std::vector<double> packed;
        packed.reserve(2 * numbering.nodes.size());
        for (const std::size_t node : numbering.nodes) {
            packed.push_back(load[2 * node]);
            packed.push_back(load[2 * node + 1]);
        }
        packed = cholesky.solve(packed);
        std::vector<double> result(load.size(), 0.0);
        for (std::size_t p = 0; p < numbering.nodes.size(); ++p) {
            result[2 * numbering.nodes[p]] = packed[2 * p];
            result[2 * numbering.nodes[p] + 1] = packed[2 * p + 1];
        }
        return result;
    }
};

PixelSolver::PixelSolver(PixelModel model, Held held) {
    BEAD_EXPECTS(held.size() == 2 * model.grid.nodes());
    BEAD_EXPECTS(model.factor.size() == model.grid.pixels());
    BEAD_EXPECTS(model.laws.empty() || model.laws.size() == model.factor.size());
    SolidNumbering numbering = solid_numbering(model);
    FrontalCholesky cholesky = factored(model, held, numbering);
    factor_ = std::make_unique<Factor>(
        Factor{std::move(model), std::move(held), std::move(numbering), std::move(cholesky)});
}

PixelSolver::PixelSolver(PixelSolver&&) noexcept = default;
PixelSolver& PixelSolver::operator=(PixelSolver&&) noexcept = default;
PixelSolver::~PixelSolver() = default;

std::optional<std::size_t> PixelSolver::loose_node() const {
    const std::optional<std::size_t> unknown = factor_->cholesky.singular();
    if (!unknown) return std::nullopt;
    return factor_->numbering.nodes[*unknown / 2];
}

const PixelModel& PixelSolver::model() const { return factor_->model; }
const Held& PixelSolver::held() const { return factor_->held; }
std::size_t PixelSolver::unknowns() const { return 2 * factor_->numbering.nodes.size(); }
std::size_t PixelSolver::fill() const { return factor_->cholesky.fill(); }

PixelVector PixelSolver::solve_only(std::span<const double> load) const {
    return factor_->applied(load);
}

const std::vector<std::size_t>& PixelSolver::solid_nodes() const {
    return factor_->numbering.nodes;
}

std::vector<double> PixelSolver::solve_packed(std::span<const double> loads, int columns) const {
    return factor_->cholesky.solve(loads, columns);
}

Displacement PixelSolver::solve(std::span<const double> load) const {
    Displacement result;
    result.values = factor_->applied(load);
    const PixelVector supported = reactions(factor_->model, factor_->held, load, result.values);
    const PixelVector all = forces(factor_->model, result.values);
    double error = 0, size = 0;
    for (std::size_t i = 0; i < load.size(); ++i) {
        const double missing = load[i] + supported[i] - all[i];
        error += missing * missing;
        size += load[i] * load[i];
    }
    result.residual = size > 0 ? std::sqrt(error / size) : 0;
    result.converged = result.residual < 1e-6;
    return result;
}

Displacement PixelSolver::solve_changed(const PixelModel& changed, std::span<const double> load,
                                        const IterationOptions& options) const {
    BEAD_EXPECTS(changed.factor.size() == factor_->model.factor.size());
    const Held& held = factor_->held;
    const std::vector<double> sums = diagonal(changed);
    const LinearMap stiffness = [&](std::span<const double> u) {
        std::vector<double> f = forces(changed, u);
        zero_held(held, f);
        return f;
    };
    // Nodes that the factor does not know are scaled by their own stiffness.
    const LinearMap nearly = [&](std::span<const double> r) {
        std::vector<double> z = factor_->applied(r);
        for (std::size_t i = 0; i < z.size(); ++i) {
            if (factor_->numbering.point_of[i / 2] >= 0) continue;
            z[i] = sums[i] > 0 ? r[i] / sums[i] : 0;
        }
        zero_held(held, z);
        return z;
    };
    std::vector<double> right(load.begin(), load.end());
    zero_held(held, right);
    for (std::size_t i = 0; i < right.size(); ++i)
        if (sums[i] == 0) right[i] = 0;
    const GradientSolution s = conjugate_gradients(
        stiffness, right, nearly,
        {.tolerance = options.tolerance, .most = options.most, .start = options.start});
    return {s.x, s.converged, s.residual, s.iterations};
}

PixelVector reactions(const PixelModel& model, const Held& held, std::span<const double> load,
                      std::span<const double> displacement) {
    PixelVector result = forces(model, displacement);
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = held[i] != 0 ? result[i] - load[i] : 0;
    return result;
}

double work(std::span<const double> load, std::span<const double> displacement) {
    double sum = 0;
    for (std::size_t i = 0; i < load.size(); ++i) sum += load[i] * displacement[i];
    return sum;
}

}  // namespace bead
