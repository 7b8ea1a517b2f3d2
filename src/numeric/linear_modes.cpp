#include "numeric/linear_modes.h"

#define EIGEN_MPL2_ONLY
#include <Eigen/Dense>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "core/expects.h"

namespace bead {

std::vector<LinearMode> linear_modes(const std::vector<double>& matrix, std::size_t order) {
    BEAD_EXPECTS(order > 0 && matrix.size() == order * order);
    const auto n = Eigen::Index(order);
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::EigenSolver<Matrix> solver(Eigen::Map<const Matrix>(matrix.data(), n, n));
    const Eigen::MatrixXcd right = solver.eigenvectors();
    const Eigen::MatrixXcd left = right.partialPivLu().inverse();

    std::vector<LinearMode> modes;
    for (Eigen::Index k = 0; k < n; ++k) {
        const std::complex<double> eigenvalue = solver.eigenvalues()(k);
        if (eigenvalue.imag() < 0) continue;
        LinearMode& mode = modes.emplace_back();
        mode.eigenvalue = eigenvalue;
        const double share = eigenvalue.imag() > 0 ? 2 : 1;  // its twin's part of the sum
        for (Eigen::Index i = 0; i < n; ++i) {
            mode.shape.push_back(share * right(i, k));
            mode.weights.push_back(left(k, i));
        }
    }
    std::ranges::stable_sort(modes, [](const LinearMode& a, const LinearMode& b) {
        return std::abs(a.eigenvalue) < std::abs(b.eigenvalue);
    });
    return modes;
}

double frequency(const LinearMode& mode) {
    return std::abs(mode.eigenvalue) / (2 * std::numbers::pi);
}

double damping_ratio(const LinearMode& mode) {
    return -mode.eigenvalue.real() / std::abs(mode.eigenvalue);
}

std::vector<std::complex<double>> steady_state(const std::vector<LinearMode>& modes,
                                               const std::vector<double>& b,
                                               std::complex<double> s) {
    std::vector<std::complex<double>> x(b.size());
    for (const LinearMode& mode : modes) {
        const std::complex<double> drive =
            std::inner_product(b.begin(), b.end(), mode.weights.begin(), std::complex<double>{});
        const std::complex<double> z = drive / (s - mode.eigenvalue);
        const std::complex<double> twin = std::conj(drive) / (s - std::conj(mode.eigenvalue));
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] += 0.5 * (mode.shape[i] * z + std::conj(mode.shape[i]) * twin);
    }
    return x;
}

}  // namespace bead
