// A linear system x' = A·x as independent modes: each is one complex number z with z' = λ·z, of
// which the state is the sum. So a step of any length is exact: z(t + h) = e^{λh}·z(t), which is
// the matrix exponential without the matrix.
//
//     x = Σ Re(shape·z),   z = weights·x
#pragma once
#include <complex>
#include <cstddef>
#include <vector>

namespace bead {

struct LinearMode {
    std::complex<double> eigenvalue;  // of a conjugate pair the one with an imaginary part above 0
    std::vector<std::complex<double>> shape, weights;  // as long as the state
};

// `matrix` by rows, order × order; eigenvalues must differ. Slowest first.
std::vector<LinearMode> linear_modes(const std::vector<double>& matrix, std::size_t order);

double frequency(const LinearMode& mode);      // Hz, |λ|/2π
double damping_ratio(const LinearMode& mode);  // -Re λ/|λ|; above or equal to 1: it does not swing

// Steady state at s (1/s, i·ω for a sine) of x' = A·x + b·u: x = (s - A)⁻¹·b.
std::vector<std::complex<double>> steady_state(const std::vector<LinearMode>& modes,
                                               const std::vector<double>& b,
                                               std::complex<double> s);

}  // namespace bead
