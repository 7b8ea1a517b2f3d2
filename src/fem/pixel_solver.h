// A prepared solver for pixel models: factor once (multifrontal Cholesky,
// numeric/frontal_cholesky.h), then solve for as many load vectors as there are. For up to a few
// 100 000 unknowns; for larger solid ones see fem/pixel_multigrid.h.
//
//     const PixelSolver solver(model, held);
//     const Displacement u = solver.solve(load);
//     const Displacement w = solver.solve_changed(braced, load);   // a few pixels more or less
#pragma once
#include <memory>
#include <optional>
#include <span>

#include "fem/displacement.h"
#include "fem/pixel_model.h"

namespace bead {

struct IterationOptions {
    double tolerance = 1e-8;  // of the residual
    int most = 200;
    std::vector<double> start;  // empty: 0
};

class PixelSolver {
  public:
    PixelSolver(PixelModel model, Held held);
    PixelSolver(PixelSolver&&) noexcept;
    PixelSolver& operator=(PixelSolver&&) noexcept;
    ~PixelSolver();

    // Nothing, or a node that moves without any force: the supports do not hold it.
    [[nodiscard]] std::optional<std::size_t> loose_node() const;
    [[nodiscard]] const PixelModel& model() const;
    [[nodiscard]] const Held& held() const;
    // Free unknowns, and numbers in the factor.
    [[nodiscard]] std::size_t unknowns() const;
    [[nodiscard]] std::size_t fill() const;

    [[nodiscard]] Displacement solve(std::span<const double> load) const;
    // The same without a look at the residual.
    [[nodiscard]] PixelVector solve_only(std::span<const double> load) const;
    // Nodes that touch something solid: vectors over two unknowns each, packed, instead of over all
    // of the grid.
    [[nodiscard]] const std::vector<std::size_t>& solid_nodes() const;
    // Several packed loads, one after the other, which cost little more than one.
    [[nodiscard]] std::vector<double> solve_packed(std::span<const double> loads,
                                                   int columns) const;
    // Solves another model on the same grid with the same supports by conjugate gradients with this
    // factor as preconditioner: a few iterations if few pixels differ. Not converged where too many
    // do; factor anew then.
    [[nodiscard]] Displacement solve_changed(const PixelModel& changed,
                                             std::span<const double> load,
                                             const IterationOptions& options = {}) const;

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

// Forces that the supports give: K u - f on held unknowns, 0 elsewhere.
PixelVector reactions(const PixelModel& model, const Held& held, std::span<const double> load,
                      std::span<const double> displacement);
// Force times displacement.
double work(std::span<const double> load, std::span<const double> displacement);

}  // namespace bead
