#include "numeric/frontal_cholesky.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/expects.h"
#include "numeric/front_kernel.h"
#include "numeric/panel_kernels.h"

namespace bead {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A pivot this small against what stood there first is rounding.
constexpr double rounding = 1e-13;

}  // namespace

struct FrontalCholesky::Panels {
    // The columns of L of a front's own unknowns, from its first row down.
    struct Panel {
        MatrixXd columns;

        [[nodiscard]] DensePanel dense() const {
            return {columns.data(), columns.cols(), columns.rows() - columns.cols()};
        }
    };

    EliminationTree tree;
    std::vector<Panel> panels;
    std::vector<std::uint8_t> held;
    std::optional<std::size_t> singular;

    [[nodiscard]] Index per_point() const { return tree.pattern.unknowns_per_point; }
    void assemble(const Front& front, MatrixXd& sum, const ElementMatrix& matrix,
                  std::span<const int> local) const;
    void add_remainder(const Front& child, const MatrixXd& remainder, MatrixXd& sum,
                       std::span<const int> local) const;
    void hold(const Front& front, MatrixXd& sum) const;
    MatrixXd eliminate(std::size_t place, MatrixXd& sum);
    void factor(const ElementMatrix& matrix);
};

void FrontalCholesky::Panels::assemble(const Front& front, MatrixXd& sum,
                                       const ElementMatrix& matrix,
                                       std::span<const int> local) const {
    const Index b = per_point();
    const auto count = std::size_t(tree.pattern.points_per_element);
    const Index size = Index(count) * b;
    std::vector<double> values(std::size_t(size * size));
    std::vector<Index> place(static_cast<std::size_t>(size));
    for (const int element : front.elements) {
        matrix(std::size_t(element), values);
        for (std::size_t p = 0; p < count; ++p) {
            const int point = tree.pattern.points[std::size_t(element) * count + p];
            for (Index c = 0; c < b; ++c) {
                const std::size_t unknown = std::size_t(b * point + c);
                place[p * std::size_t(b) + std::size_t(c)] =
                    held[unknown] != 0 ? -1 : b * local[std::size_t(point)] + c;
            }
        }
        for (Index col = 0; col < size; ++col) {
            const Index to = place[std::size_t(col)];
            if (to < 0) continue;
            for (Index row = 0; row < size; ++row) {
                const Index at = place[std::size_t(row)];
                if (at >= to) sum(at, to) += values[std::size_t(col * size + row)];
            }
        }
    }
}

void FrontalCholesky::Panels::add_remainder(const Front& child, const MatrixXd& remainder,
                                            MatrixXd& sum, std::span<const int> local) const {
    const Index b = per_point();
    for (std::size_t q = 0; q < child.border.size(); ++q) {
        const Index to = b * local[std::size_t(child.border[q])];
        for (std::size_t p = q; p < child.border.size(); ++p) {
            const Index at = b * local[std::size_t(child.border[p])];
            for (Index c = 0; c < b; ++c)
                for (Index r = p == q ? c : 0; r < b; ++r)
                    sum(at + r, to + c) += remainder(Index(p) * b + r, Index(q) * b + c);
        }
    }
}

void FrontalCholesky::Panels::hold(const Front& front, MatrixXd& sum) const {
    const Index b = per_point();
    for (std::size_t p = 0; p < front.own.size(); ++p)
        for (Index c = 0; c < b; ++c)
            if (held[std::size_t(b * front.own[p] + c)] != 0)
                sum(Index(p) * b + c, Index(p) * b + c) = 1;
}

// Factors the own part and returns what is left for the parent.
MatrixXd FrontalCholesky::Panels::eliminate(std::size_t place, MatrixXd& sum) {
    const Front& front = tree.fronts[place];
    const Index own = Index(front.own.size()) * per_point();
    const Index rest = sum.rows() - own;
    if (own == 0) return std::move(sum);  // halves that do not touch
    const VectorXd before = sum.diagonal().head(own);
    eliminate_first(sum.data(), sum.rows(), own);
    if (!singular)
        for (Index i = 0; i < own; ++i)
            if (!(sum(i, i) * sum(i, i) > rounding * before(i))) {
                singular = std::size_t(front.own[std::size_t(i / per_point())]) *
                               std::size_t(per_point()) +
                           std::size_t(i % per_point());
                break;
            }
    panels[place].columns = sum.leftCols(own);
    return sum.bottomRightCorner(rest, rest);
}

void FrontalCholesky::Panels::factor(const ElementMatrix& matrix) {
    panels.resize(tree.fronts.size());
    std::vector<int> local(tree.pattern.places.size(), -1);
    // Fronts are in postorder: a front's children are the last ones still waiting.
    std::vector<std::pair<std::size_t, MatrixXd>> waiting;
    for (std::size_t f = 0; f < tree.fronts.size() && !singular; ++f) {
        const Front& front = tree.fronts[f];
        int next = 0;
        for (const int point : front.own) local[std::size_t(point)] = next++;
        for (const int point : front.border) local[std::size_t(point)] = next++;
        MatrixXd sum = MatrixXd::Zero(next * per_point(), next * per_point());
        assemble(front, sum, matrix, local);
        for (int c = 0; c < front.children; ++c) {
            const auto& [child, remainder] = waiting.back();
            add_remainder(tree.fronts[child], remainder, sum, local);
            waiting.pop_back();
        }
        hold(front, sum);
        waiting.emplace_back(f, eliminate(f, sum));
    }
}

// `width` right sides at once, the values of an unknown side by side: each number of the factor is
// read once for all of them.
template <std::ptrdiff_t width>
class FrontalCholesky::Sweep {
  public:
    explicit Sweep(const Panels& panels) : panels_(panels), b_(panels.per_point()) {
        std::size_t rows = 0;
        for (const Front& front : panels.tree.fronts)
            rows = std::max(rows, (front.own.size() + front.border.size()) * std::size_t(b_));
        part_.resize(rows * std::size_t(width));
    }

    // `x`: `columns` of them, at most `width`, one after the other; in place.
    void solve(double* x, Index rows, Index columns) {
        values_.assign(std::size_t(rows * width), 0.0);
        for (Index k = 0; k < columns; ++k)
            for (Index i = 0; i < rows; ++i)
                if (panels_.held[std::size_t(i)] == 0)
                    values_[std::size_t(i * width + k)] = x[k * rows + i];
        for (std::size_t f = 0; f < panels_.panels.size(); ++f) forward(f);
        std::fill(x, x + rows * columns, 0.0);
        for (std::size_t f = panels_.panels.size(); f-- > 0;) {
            backward(f);
            for (const int point : panels_.tree.fronts[f].own)
                for (Index c = point * b_; c < point * b_ + b_; ++c)
                    for (Index k = 0; k < columns; ++k)
                        x[k * rows + c] = values_[std::size_t(c * width + k)];
        }
    }

  private:
    void gather(std::span<const int> points, double* to) const {
        const Index block = b_ * width;
        for (std::size_t p = 0; p < points.size(); ++p)
            std::copy_n(&values_[std::size_t(points[p] * block)], block, to + Index(p) * block);
    }
    void scatter(std::span<const int> points, const double* from) {
        const Index block = b_ * width;
        for (std::size_t p = 0; p < points.size(); ++p)
            std::copy_n(from + Index(p) * block, block, &values_[std::size_t(points[p] * block)]);
    }

    void forward(std::size_t f) {
        const Front& front = panels_.tree.fronts[f];
        const DensePanel panel = panels_.panels[f].dense();
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
        const Front& front = panels_.tree.fronts[f];
        const DensePanel panel = panels_.panels[f].dense();
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

    const Panels& panels_;
    const Index b_;
    std::vector<double> values_, part_;
};

FrontalCholesky::FrontalCholesky(EliminationTree tree, const ElementMatrix& matrix,
                                 std::span<const std::uint8_t> held)
    : panels_(std::make_unique<Panels>()) {
    BEAD_EXPECTS(held.size() ==
                 tree.pattern.places.size() * std::size_t(tree.pattern.unknowns_per_point));
    panels_->tree = std::move(tree);
    panels_->held.assign(held.begin(), held.end());
    panels_->factor(matrix);
}

FrontalCholesky::FrontalCholesky(FrontalCholesky&&) noexcept = default;
FrontalCholesky& FrontalCholesky::operator=(FrontalCholesky&&) noexcept = default;
FrontalCholesky::~FrontalCholesky() = default;

std::optional<std::size_t> FrontalCholesky::singular() const { return panels_->singular; }

std::size_t FrontalCholesky::fill() const {
    std::size_t count = 0;
    for (const Panels::Panel& panel : panels_->panels) count += std::size_t(panel.columns.size());
    return count;
}

std::vector<double> FrontalCholesky::solve(std::span<const double> right_sides, int columns) const {
    BEAD_EXPECTS(!panels_->singular);
    BEAD_EXPECTS(right_sides.size() == panels_->held.size() * std::size_t(columns));
    const auto rows = Index(panels_->held.size());
    std::vector<double> answer(right_sides.begin(), right_sides.end());
    if (columns == 1) {
        Sweep<1>(*panels_).solve(answer.data(), rows, 1);
        return answer;
    }
    Sweep<panel_width> sweep(*panels_);
    for (Index first = 0; first < columns; first += panel_width)
        sweep.solve(&answer[std::size_t(first * rows)], rows,
                    std::min<Index>(panel_width, columns - first));
    return answer;
}

}  // namespace bead
