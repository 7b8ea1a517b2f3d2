// Linear buckling in the plane: load factors lambda > 0 at which K phi = -lambda Kg phi has a
// solution, Kg being the geometric stiffness of the stresses under the unit load. Found by Lanczos'
// method on -K^-1 Kg in the inner product of K (Ericsson and Ruhe 1980), the solver giving K^-1.
// A column under compression that buckles at twice its load has lambda = 2.
#pragma once
#include <span>
#include <vector>

#include "fem/pixel_solver.h"

namespace bead {

struct BucklingMode {
    double factor = 0;  // lambda
    PixelVector shape;  // K-orthonormal: phi^T K phi = 1, its energy sums to 1 over the pixels
};

struct BucklingOptions {
    int count = 2;                     // lowest modes wanted
    double tolerance = 1e-3;           // relative, of the first factor
    double others = 1e-3;              // of the other ones
    int most = 120;                    // Lanczos vectors
    std::vector<PixelVector> start{};  // guesses of the first modes, besides seeded noise
};

struct Buckling {
    std::vector<BucklingMode> modes;  // lowest first; fewer than wanted where no more are positive
    bool converged = false;
    int steps = 0;
};

// `displacement` is the solver's answer to the unit load.
Buckling buckling(const PixelSolver& solver, std::span<const double> displacement,
                  const BucklingOptions& options = {});

// Kg x for the stresses of the displacement.
PixelVector geometric_forces(const PixelModel& model, std::span<const double> displacement,
                             std::span<const double> shape);

}  // namespace bead
