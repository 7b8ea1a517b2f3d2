// The largest eigenvalues mu of a map A that is symmetric in the inner product of a positive
// definite B: A x = mu x, by Lanczos' method with full orthogonalisation in that product (Parlett
// 1980). For vibration A = K^-1 M, for buckling A = -K^-1 Kg, both with B = K: mu is then the
// inverse of what is wanted lowest.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "numeric/conjugate_gradients.h"

namespace bead {

struct ModeOptions {
    int count = 2;
    double tolerance = 1e-3;  // relative error of the eigenvalues, estimated
    int most = 80;            // steps
    std::vector<double> start{};
};

struct Mode {
    double value = 0;
    std::vector<double> shape;  // B-orthonormal
};

struct Modes {
    std::vector<Mode> modes;  // the largest first; only positive ones
    bool converged = false;
    int steps = 0;
};

// `a_times` and `b_times` apply A and B; the start must not be 0.
Modes largest_modes(const LinearMap& a_times, const LinearMap& b_times, const ModeOptions& options);

}  // namespace bead
