#include "numeric/linear_modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace bead {
namespace {

constexpr std::size_t n = 4;
using State = std::vector<double>;

std::vector<double> random_matrix(unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0, 1);
    std::vector<double> a(n * n);
    for (double& value : a) value = normal(random);
    for (std::size_t i = 0; i < n; ++i) a[i * n + i] -= 3;
    return a;
}

State times(const std::vector<double>& a, const State& x) {
    State y(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) y[i] += a[i * n + j] * x[j];
    return y;
}

// e^{At}·x by its series, in small steps: slow and plain.
State twin(const std::vector<double>& a, State x, double t) {
    constexpr int steps = 64;
    for (int k = 0; k < steps; ++k) {
        State term = x;
        for (int order = 1; order < 20; ++order) {
            term = times(a, term);
            for (std::size_t i = 0; i < n; ++i) {
                term[i] *= t / steps / order;
                x[i] += term[i];
            }
        }
    }
    return x;
}

TEST(LinearModes, AreTheMatrixExponential) {
    for (unsigned seed = 1; seed < 20; ++seed) {
        const auto a = random_matrix(seed);
        const State start{1, -2, 0.5, 3};
        const State exact = twin(a, start, 0.7);
        State x(n);
        for (const LinearMode& mode : linear_modes(a, n)) {
            std::complex<double> z = std::inner_product(
                start.begin(), start.end(), mode.weights.begin(), std::complex<double>{});
            z *= std::exp(0.7 * mode.eigenvalue);
            for (std::size_t i = 0; i < n; ++i) x[i] += (mode.shape[i] * z).real();
        }
        for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(x[i], exact[i], 1e-9) << seed;
    }
}

TEST(LinearModes, SteadyStateSolvesTheEquation) {
    const auto a = random_matrix(5);
    const std::vector<double> b{1, 0, 2, -1};
    const std::complex<double> s(0.1, 2);
    const auto x = steady_state(linear_modes(a, n), b, s);
    for (std::size_t i = 0; i < n; ++i) {
        std::complex<double> off = s * x[i] - b[i];
        for (std::size_t j = 0; j < n; ++j) off -= a[i * n + j] * x[j];
        EXPECT_LT(std::abs(off), 1e-9);
    }
}

}  // namespace
}  // namespace bead
