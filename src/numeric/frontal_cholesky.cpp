#include "numeric/frontal_cholesky.h"

#include <algorithm>

#include "core/expects.h"
#include "numeric/panel_kernels.h"

namespace bead {
namespace {

// `width` right sides at once, the values of an unknown side by side: each number of the factor is
// read once for all of them. The values lie in the order of elimination, so that a front's own are
// together. `b`: unknowns per point.
template <std::ptrdiff_t width, std::ptrdiff_t b>
class Sweep {
  public:
    explicit Sweep(const FrontalFactor& factor) : factor_(factor) {
        std::size_t points = 0;
        for (const Front& front : factor.tree.fronts)
            points = std::max(points, front.border.size());
        border_.resize(points * block);
        values_.resize(factor.order.size() * block);
    }

    // `x`: `columns` right sides of `rows` each, at most `width`, one after the other; `to` is 0
    // before.
    void solve(const double* x, std::size_t rows, std::size_t columns, double* to) {
        load(x, rows, columns);
        sweep();
        store(to, rows, columns);
    }

  private:
    static constexpr std::size_t block = width * b;

    void load(const double* x, std::size_t rows, std::size_t columns) {
        double* to = values_.data();
        for (const std::size_t point : factor_.order)
            for (std::size_t i = point * b; i < (point + 1) * b; ++i, to += width) {
                std::fill_n(to, width, 0);
                for (std::size_t k = 0; k < columns && factor_.held[i] == 0; ++k)
                    to[k] = x[k * rows + i];
            }
    }
    void store(double* x, std::size_t rows, std::size_t columns) const {
        const double* from = values_.data();
        for (const std::size_t point : factor_.order)
            for (std::size_t i = point * b; i < (point + 1) * b; ++i, from += width)
                for (std::size_t k = 0; k < columns; ++k) x[k * rows + i] = from[k];
    }

    void sweep() {
        const std::size_t fronts = factor_.tree.fronts.size();
        double* own = values_.data();
        const std::size_t* border = factor_.borders.data();
        for (std::size_t f = 0; f < fronts; ++f) {
            forward(factor_.panel(f), own, border);
            own += factor_.tree.fronts[f].own.size() * block;
            border += factor_.tree.fronts[f].border.size();
        }
        for (std::size_t f = fronts; f-- > 0;) {
            own -= factor_.tree.fronts[f].own.size() * block;
            border -= factor_.tree.fronts[f].border.size();
            backward(factor_.panel(f), own, border);
        }
    }

    void gather(const std::size_t* places, std::size_t count) {
        double* to = border_.data();
        for (std::size_t p = 0; p < count; ++p, to += block) {
            const double* const from = &values_[places[p] * block];
            for (std::size_t i = 0; i < block; ++i) to[i] = from[i];
        }
    }
    void scatter(const std::size_t* places, std::size_t count) {
        const double* from = border_.data();
        for (std::size_t p = 0; p < count; ++p, from += block) {
            double* const to = &values_[places[p] * block];
            for (std::size_t i = 0; i < block; ++i) to[i] = from[i];
        }
    }

    void forward(const DensePanel& panel, double* own, const std::size_t* places) {
        if (panel.own == 0) return;
        const std::size_t count = std::size_t(panel.border / b);
        gather(places, count);
        solve_forward(panel, width, own, border_.data());
        scatter(places, count);
    }

    void backward(const DensePanel& panel, double* own, const std::size_t* places) {
        if (panel.own == 0) return;
        gather(places, std::size_t(panel.border / b));
        solve_backward(panel, width, own, border_.data());
    }

    const FrontalFactor& factor_;
    std::vector<double> values_, border_;
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
    std::vector<double> answer(right_sides.size(), 0.0);
    with_block(factor_.tree.pattern.unknowns_per_point, [&](auto b) {
        if (columns == 1) {
            Sweep<1, b()>(factor_).solve(right_sides.data(), rows, 1, answer.data());
            return;
        }
        Sweep<panel_width, b()> sweep(factor_);
        constexpr auto width = std::size_t(panel_width);
        for (std::size_t first = 0; first < std::size_t(columns); first += width)
            sweep.solve(&right_sides[first * rows], rows,
                        std::min(width, std::size_t(columns) - first), &answer[first * rows]);
    });
    return answer;
}

}  // namespace bead
