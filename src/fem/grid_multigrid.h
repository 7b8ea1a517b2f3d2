// Solves K u = f on a regular grid of elements by conjugate gradients with one multigrid V-cycle as
// preconditioner, all without a matrix. Coarser grids have elements twice as large with the mean of
// the stiffness; each smooths by Chebyshev's polynomial of second degree on Jacobi's iteration, in
// single precision; the coarsest is factored. The outer iteration, its products and its residuals
// are in double precision (Kronbichler and Ljungkvist 2019; Amir, Aage and Lazarov 2014). Some 80
// bytes per unknown.
#pragma once
#include <cstdint>
#include <span>

#include "fem/displacement.h"
#include "fem/grid_operator.h"

namespace bead {

struct MultigridOptions {
    double tolerance = 1e-8;  // of the residual
    int most = 500;
};

// `load` and the answer are ordered by node, then component; so is `held`.
Displacement multigrid_solution(ElasticGrid grid, std::span<const std::uint8_t> held,
                                std::span<const double> load, const MultigridOptions& options);

}  // namespace bead
