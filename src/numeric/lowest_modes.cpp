#include "numeric/lowest_modes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/expects.h"

namespace bead {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using VectorMap = Eigen::Map<const VectorXd>;

VectorXd applied(const LinearMap& map, const VectorXd& x) {
    const std::vector<double> y = map(std::span(x.data(), std::size_t(x.size())));
    return VectorMap(y.data(), Index(y.size()));
}

class Lanczos {
  public:
    Lanczos(const LinearMap& a, const LinearMap& b, const ModeOptions& options)
        : a_(a), b_(b), options_(options), projected_(MatrixXd::Zero(options.most, options.most)) {}

    Modes run();

  private:
    bool extend(const VectorXd& candidate, double& size);
    [[nodiscard]] int settled(const Eigen::SelfAdjointEigenSolver<MatrixXd>& small,
                              double rest) const;
    [[nodiscard]] Modes modes_of(const Eigen::SelfAdjointEigenSolver<MatrixXd>& small,
                                 int found) const;

    const LinearMap& a_;
    const LinearMap& b_;
    const ModeOptions& options_;
    std::vector<VectorXd> basis_, b_basis_;
    MatrixXd projected_;
};

// Adds the candidate, a vector orthogonal to the basis but for rounding; its size in B comes back.
bool Lanczos::extend(const VectorXd& candidate, double& size) {
    VectorXd v = candidate;
    for (std::size_t k = 0; k < basis_.size(); ++k) v -= b_basis_[k].dot(v) * basis_[k];
    VectorXd bv = applied(b_, v);
    const double square = v.dot(bv);
    size = square > 0 ? std::sqrt(square) : 0;
    if (size < 1e-300) return false;
    basis_.push_back(v / size);
    b_basis_.push_back(bv / size);
    return true;
}

// How many of the wanted values are as good as they should be: the residual of a Ritz pair is its
// last component times the rest, the error of its value the square of that over the gap.
int Lanczos::settled(const Eigen::SelfAdjointEigenSolver<MatrixXd>& small, double rest) const {
    const Index n = small.eigenvalues().size();
    int good = 0;
    for (Index k = n; k-- > 0 && good < options_.count;) {
        const double value = small.eigenvalues()(k);
        if (!(value > 0)) break;
        const double residual = std::abs(rest * small.eigenvectors()(n - 1, k));
        if (residual > std::sqrt(options_.tolerance) * 0.3 * value) break;
        ++good;
    }
    return good;
}

Modes Lanczos::modes_of(const Eigen::SelfAdjointEigenSolver<MatrixXd>& small, int found) const {
    Modes result;
    const Index n = small.eigenvalues().size();
    for (int m = 0; m < found; ++m) {
        VectorXd shape = VectorXd::Zero(basis_[0].size());
        for (Index k = 0; k < n; ++k)
            shape += small.eigenvectors()(k, n - 1 - m) * basis_[std::size_t(k)];
        result.modes.push_back(
            {small.eigenvalues()(n - 1 - m), {shape.data(), shape.data() + shape.size()}});
    }
    return result;
}

Modes Lanczos::run() {
    double rest = 0;
    const VectorXd start = VectorMap(options_.start.data(), Index(options_.start.size()));
    // One application takes out what A cannot reach.
    if (!extend(applied(a_, start), rest)) return {.modes = {}, .converged = true, .steps = 0};
    Eigen::SelfAdjointEigenSolver<MatrixXd> small;
    int good = 0, step = 0;
    bool exhausted = false;
    while (step < options_.most && !exhausted) {
        VectorXd w = applied(a_, basis_.back());
        for (std::size_t k = 0; k < basis_.size(); ++k) {
            const double h = b_basis_[k].dot(w);
            projected_(Index(k), step) = projected_(step, Index(k)) = h;
            w -= h * basis_[k];
        }
        ++step;
        exhausted = !extend(w, rest) || rest < 1e-12 * projected_.cwiseAbs().maxCoeff();
        if (exhausted) rest = 0;
        if (step % 4 != 0 && !exhausted && step < options_.most) continue;
        small.compute(projected_.topLeftCorner(step, step));
        good = settled(small, rest);
        if (good >= options_.count) break;
    }
    const Index positive = (small.eigenvalues().array() > 0).count();
    const int found = int(std::min<Index>(options_.count, positive));
    Modes result = modes_of(small, exhausted ? found : std::max(good, std::min(found, 1)));
    result.converged = exhausted || good >= options_.count;
    result.steps = step;
    return result;
}

}  // namespace

Modes largest_modes(const LinearMap& a_times, const LinearMap& b_times,
                    const ModeOptions& options) {
    BEAD_EXPECTS(options.count > 0 && options.most >= options.count);
    return Lanczos(a_times, b_times, options).run();
}

}  // namespace bead
