#include "numeric/block_lanczos.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/expects.h"
#include "numeric/tall_products.h"

namespace bead {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using MatrixMap = Eigen::Map<const MatrixXd>;
using Small = Eigen::SelfAdjointEigenSolver<MatrixXd>;

constexpr double cancelled = 1e-4;     // of a square: what calls for a second orthogonalisation
constexpr double well_apart = 1e-3;    // of a square, what is left of a vector beside the others
constexpr double independent = 1e-10;  // of a vector, what must be orthogonal to the basis

struct Block {
    MatrixXd x, bx;
};

class Basis {
  public:
    Basis(Index size, const BlockOptions& options) : options_(options) {
        const Index room = options.most + options.block;
        v_.resize(size, room);
        bv_.resize(size, room);
        projected_ = MatrixXd::Zero(room, room);
    }

    [[nodiscard]] Index count() const { return count_; }
    [[nodiscard]] MatrixMap last(Index columns) const {
        return {v_.col(count_ - columns).data(), v_.rows(), columns};
    }

    // Of the images of the last `columns` vectors: what A makes of them within the basis is kept,
    // the rest stays.
    void project(Block& images, Index columns) {
        const Eigen::VectorXd whole = squares(images);
        const MatrixXd h = take_out(images);
        projected_.block(0, count_ - columns, count_, columns) = h;
        projected_.block(count_ - columns, 0, columns, count_) = h.transpose();
        if ((squares(images).array() < cancelled * whole.array()).any()) take_out(images);
    }

    // Of what is orthogonal to the basis the independent part, as a new block; how many columns.
    Index append(const Block& rest) {
        const Index before = count_, columns = rest.x.cols();
        if (append_whole(rest)) return columns;
        for (Index k = 0; k < columns; ++k) {
            Eigen::VectorXd x = rest.x.col(k), bx = rest.bx.col(k);
            const double whole = x.dot(bx);
            for (int pass = 0; pass < 2; ++pass) {
                const auto v = v_.middleCols(before, count_ - before);
                const Eigen::VectorXd h = v.transpose() * bx;
                x.noalias() -= v * h;
                bx.noalias() -= bv_.middleCols(before, count_ - before) * h;
            }
            const double square = x.dot(bx);
            if (!(square > independent * independent * whole) || !(square > 1e-280)) continue;
            v_.col(count_) = x / std::sqrt(square);
            bv_.col(count_) = bx / std::sqrt(square);
            ++count_;
        }
        return count_ - before;
    }

    [[nodiscard]] Small ritz() const { return Small(projected_.topLeftCorner(count_, count_)); }

    // How many of the wanted values are as good as they should be; `rest` is what the images of the
    // last `columns` vectors have outside of the basis.
    [[nodiscard]] int settled(const Small& small, const Block& rest, Index columns) const {
        const MatrixXd outside = rest.x.transpose() * rest.bx;
        int good = 0;
        for (Index k = count_; k-- > 0 && good < options_.count; ++good) {
            const double value = small.eigenvalues()(k);
            if (!(value > 0)) break;
            const auto end = small.eigenvectors().col(k).tail(columns);
            const double residual = std::sqrt(std::max(0.0, end.dot(outside * end)));
            const double wanted = good == 0 ? options_.tolerance : options_.others;
            if (residual > std::sqrt(wanted) * 0.3 * value) break;
        }
        return good;
    }

    [[nodiscard]] std::vector<Mode> modes(const Small& small) const {
        Index wanted = 0;
        while (wanted < std::min<Index>(options_.count, count_) &&
               small.eigenvalues()(count_ - 1 - wanted) > 0)
            ++wanted;
        const MatrixXd shapes =
            v_.leftCols(count_) * small.eigenvectors().middleCols(count_ - wanted, wanted);
        std::vector<Mode> found;
        for (Index k = wanted; k-- > 0;)
            found.push_back({small.eigenvalues()(count_ - wanted + k),
                             {shapes.col(k).begin(), shapes.col(k).end()}});
        return found;
    }

  private:
    // All columns at once, by the Cholesky factor of their products; where they are well apart.
    bool append_whole(const Block& rest) {
        const Index columns = rest.x.cols(), rows = rest.x.rows();
        MatrixXd products(columns, columns);
        inner_products({rest.x.data(), rows, columns}, {rest.bx.data(), rows, columns},
                       products.data());
        const Eigen::VectorXd squares = products.diagonal();
        if (!(squares.minCoeff() > 1e-280)) return false;
        const Eigen::LLT<MatrixXd> factor(products);
        if (factor.info() != Eigen::Success) return false;
        const MatrixXd upper = factor.matrixU();
        if ((upper.diagonal().array().square() < well_apart * squares.array()).any()) return false;
        const MatrixXd inverse =
            upper.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(columns, columns));
        v_.middleCols(count_, columns).noalias() = rest.x * inverse;
        bv_.middleCols(count_, columns).noalias() = rest.bx * inverse;
        count_ += columns;
        return true;
    }

    static Eigen::VectorXd squares(const Block& block) {
        return block.x.cwiseProduct(block.bx).colwise().sum();
    }
    MatrixXd take_out(Block& block) const {
        MatrixXd h(count_, block.bx.cols());
        const Index rows = v_.rows();
        inner_products({v_.data(), rows, count_}, {block.bx.data(), rows, h.cols()}, h.data());
        bead::take_out({v_.data(), rows, count_}, h.data(), block.x.data(), h.cols());
        bead::take_out({bv_.data(), rows, count_}, h.data(), block.bx.data(), h.cols());
        return h;
    }

    const BlockOptions& options_;
    MatrixXd v_, bv_, projected_;
    Index count_ = 0;
};

Block applied(const BlockMap& map, const MatrixMap& x) {
    const BlockImages images = map({x.data(), std::size_t(x.size())}, int(x.cols()));
    return {MatrixMap(images.a.data(), x.rows(), x.cols()),
            MatrixMap(images.ba.data(), x.rows(), x.cols())};
}

}  // namespace

Modes block_modes(const BlockMap& map, std::span<const double> start, std::size_t size,
                  const BlockOptions& options) {
    BEAD_EXPECTS(size > 0 && !start.empty() && start.size() % size == 0);
    const auto rows = static_cast<Index>(size);
    Basis basis(rows, options);
    Block next = applied(map, {start.data(), rows, static_cast<Index>(start.size() / size)});
    Modes result;
    Small small;
    while (basis.count() + next.x.cols() <= options.most) {
        const Index columns = basis.append(next);
        if (columns == 0) {
            result.converged = true;
            break;
        }
        next = applied(map, basis.last(columns));
        basis.project(next, columns);
        small = basis.ritz();
        result.converged = basis.settled(small, next, columns) >= options.count;
        if (result.converged) break;
    }
    result.steps = int(basis.count());
    if (basis.count() > 0) result.modes = basis.modes(small);
    return result;
}

}  // namespace bead
