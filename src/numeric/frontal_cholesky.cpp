#include "numeric/frontal_cholesky.h"

#include <algorithm>

#include "core/expects.h"
#include "numeric/panel_kernels.h"

namespace bead {
namespace {

// `width` right sides at once, the values of an unknown side by side: each number of the factor is
// read once for all of them. `b`: unknowns per point.
template <std::ptrdiff_t width, std::ptrdiff_t b>
class Sweep {
  public:
    explicit Sweep(const FrontalFactor& factor) : factor_(factor) {
        std::size_t points = 0;
        for (const Front& front : factor.tree.fronts)
            points = std::max(points, front.own.size() + front.border.size());
        part_.resize(points * block);
    }

    // `x`: `columns` of them, at most `width`, one after the other; in place.
    void solve(double* x, std::size_t rows, std::size_t columns) {
        values_.assign(rows * std::size_t(width), 0.0);
        for (std::size_t k = 0; k < columns; ++k)
            for (std::size_t i = 0; i < rows; ++i)
                if (factor_.held[i] == 0) values_[i * std::size_t(width) + k] = x[k * rows + i];
        const std::size_t fronts = factor_.tree.fronts.size();
        for (std::size_t f = 0; f < fronts; ++f) forward(f);
        std::fill(x, x + rows * columns, 0.0);
        for (std::size_t f = fronts; f-- > 0;) {
            backward(f);
            for (const int point : factor_.tree.fronts[f].own)
                for (std::size_t c = std::size_t(point * b); c < std::size_t(point * b + b); ++c)
                    for (std::size_t k = 0; k < columns; ++k)
                        x[k * rows + c] = values_[c * std::size_t(width) + k];
        }
    }

  private:
    static constexpr std::size_t block = width * b;

    void gather(std::span<const int> points, double* to) const {
        for (const int point : points) {
            const double* const from = &values_[std::size_t(point) * block];
            for (std::size_t i = 0; i < block; ++i) to[i] = from[i];
            to += block;
        }
    }
    void scatter(std::span<const int> points, const double* from) {
        for (const int point : points) {
            double* const to = &values_[std::size_t(point) * block];
            for (std::size_t i = 0; i < block; ++i) to[i] = from[i];
            from += block;
        }
    }

    void forward(std::size_t f) {
        const Front& front = factor_.tree.fronts[f];
        const DensePanel panel = factor_.panel(f);
        if (panel.own == 0) return;
        double *const own = part_.data(), *const border = own + panel.own * width;
        gather(front.own, own);
        gather(front.border, border);
        if constexpr (width == 1)
            solve_one_forward(panel, own, border);
        else
            solve_forward(panel, own, border);
        scatter(front.own, own);
        scatter(front.border, border);
    }

    void backward(std::size_t f) {
        const Front& front = factor_.tree.fronts[f];
        const DensePanel panel = factor_.panel(f);
        if (panel.own == 0) return;
        double *const own = part_.data(), *const border = own + panel.own * width;
        gather(front.own, own);
        gather(front.border, border);
        if constexpr (width == 1)
            solve_one_backward(panel, own, border);
        else
            solve_backward(panel, own, border);
        scatter(front.own, own);
    }

    const FrontalFactor& factor_;
    std::vector<double> values_, part_;
};

}  // namespace

FrontalCholesky::FrontalCholesky(EliminationTree tree, const ElementMatrix& matrix,
                                 std::span<const std::uint8_t> held) {
    const int block = tree.pattern.unknowns_per_point;
    BEAD_EXPECTS(block >= 1 && block <= 3);
    BEAD_EXPECTS(held.size() == tree.pattern.places.size() * std::size_t(block));
    factor_ = frontal_factor(std::move(tree), matrix, held);
}

std::optional<std::size_t> FrontalCholesky::singular() const { return factor_.singular; }

std::size_t FrontalCholesky::fill() const { return factor_.begin.back(); }

std::vector<double> FrontalCholesky::solve(std::span<const double> right_sides, int columns) const {
    BEAD_EXPECTS(!factor_.singular);
    const std::size_t rows = factor_.held.size();
    BEAD_EXPECTS(right_sides.size() == rows * std::size_t(columns));
    std::vector<double> answer(right_sides.begin(), right_sides.end());
    with_block(factor_.tree.pattern.unknowns_per_point, [&](auto b) {
        if (columns == 1) {
            Sweep<1, b()>(factor_).solve(answer.data(), rows, 1);
            return;
        }
        Sweep<panel_width, b()> sweep(factor_);
        constexpr auto width = std::size_t(panel_width);
        for (std::size_t first = 0; first < std::size_t(columns); first += width)
            sweep.solve(&answer[first * rows], rows, std::min(width, std::size_t(columns) - first));
    });
    return answer;
}

}  // namespace bead
