// Conjugate gradients with a preconditioner (Hestenes and Stiefel 1952) for a symmetric positive
// definite operator that is only known by what it does to vectors.
#pragma once
#include <functional>
#include <span>
#include <vector>

namespace bead {

using LinearMap = std::function<std::vector<double>(std::span<const double>)>;

struct GradientOptions {
    double tolerance = 1e-8;  // of |b - A x| / |b|
    int most = 1000;
    std::vector<double> start{};  // empty: 0
};

struct GradientSolution {
    std::vector<double> x;
    bool converged = false;
    double residual = 0;  // relative
    int iterations = 0;
};

GradientSolution conjugate_gradients(const LinearMap& a, std::span<const double> b,
                                     const LinearMap& preconditioner,
                                     const GradientOptions& options = {});

}  // namespace bead
