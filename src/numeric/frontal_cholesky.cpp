#include "numeric/frontal_cholesky.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/expects.h"

namespace bead {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A pivot this small against what stood there first is rounding.
constexpr double negligible = 1e-13;

struct Panel {
    MatrixXd triangle;  // lower, of the own unknowns
    MatrixXd below;     // border by own

    // One step of solving with L and with its transpose.
    void forward(VectorXd& own, VectorXd& border) const {
        triangle.triangularView<Eigen::Lower>().solveInPlace(own);
        border.noalias() -= below * own;
    }
    void backward(VectorXd& own, const VectorXd& border) const {
        own.noalias() -= below.transpose() * border;
        triangle.triangularView<Eigen::Lower>().transpose().solveInPlace(own);
    }
    // A few columns: each column of the panel is read once for all of them.
    void forward(MatrixXd& own, MatrixXd& border) const {
        const Index n = own.rows();
        for (Index j = 0; j < n; ++j)
            for (Index k = 0; k < own.cols(); ++k) {
                const double x = own(j, k) /= triangle(j, j);
                own.col(k).tail(n - j - 1) -= x * triangle.col(j).tail(n - j - 1);
                border.col(k) -= x * below.col(j);
            }
    }
    void backward(MatrixXd& own, const MatrixXd& border) const {
        const Index n = own.rows();
        for (Index j = n; j-- > 0;)
            for (Index k = 0; k < own.cols(); ++k)
                own(j, k) = (own(j, k) - below.col(j).dot(border.col(k)) -
                             triangle.col(j).tail(n - j - 1).dot(own.col(k).tail(n - j - 1))) /
                            triangle(j, j);
    }
};

}  // namespace

struct FrontalCholesky::Panels {
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
    // X: one vector, or several as columns, their rows together.
    template <class X>
    [[nodiscard]] X gathered(std::span<const int> points, const X& x) const;
    template <class X>
    void scatter(std::span<const int> points, const X& part, X& x) const;
    template <class X>
    [[nodiscard]] X solved(X x) const;
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
    Eigen::Ref<MatrixXd> block = sum.topLeftCorner(own, own);
    const Eigen::LLT<Eigen::Ref<MatrixXd>> factored(block);
    if (!singular)
        for (Index i = 0; i < own; ++i)
            if (factored.info() != Eigen::Success ||
                !(sum(i, i) * sum(i, i) > negligible * before(i))) {
                singular = std::size_t(front.own[std::size_t(i / per_point())]) *
                               std::size_t(per_point()) +
                           std::size_t(i % per_point());
                break;
            }
    Panel& panel = panels[place];
    panel.triangle = sum.topLeftCorner(own, own);
    panel.below = sum.bottomLeftCorner(rest, own);
    MatrixXd remainder = sum.bottomRightCorner(rest, rest);
    if (rest > 0) {
        panel.triangle.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(
            panel.below);
        remainder.selfadjointView<Eigen::Lower>().rankUpdate(panel.below, -1);
    }
    return remainder;
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

template <class X>
X FrontalCholesky::Panels::gathered(std::span<const int> points, const X& x) const {
    const Index b = per_point();
    X part(Index(points.size()) * b, x.cols());
    for (std::size_t p = 0; p < points.size(); ++p)
        part.middleRows(Index(p) * b, b) = x.middleRows(points[p] * b, b);
    return part;
}

template <class X>
void FrontalCholesky::Panels::scatter(std::span<const int> points, const X& part, X& x) const {
    const Index b = per_point();
    for (std::size_t p = 0; p < points.size(); ++p)
        x.middleRows(points[p] * b, b) = part.middleRows(Index(p) * b, b);
}

template <class X>
X FrontalCholesky::Panels::solved(X x) const {
    for (std::size_t i = 0; i < held.size(); ++i)
        if (held[i] != 0) x.row(Index(i)).setZero();
    for (std::size_t f = 0; f < panels.size(); ++f) {
        if (tree.fronts[f].own.empty()) continue;
        X own = gathered(tree.fronts[f].own, x);
        X border = gathered(tree.fronts[f].border, x);
        panels[f].forward(own, border);
        scatter(tree.fronts[f].own, own, x);
        scatter(tree.fronts[f].border, border, x);
    }
    X result = X::Zero(x.rows(), x.cols());
    for (std::size_t f = panels.size(); f-- > 0;) {
        if (tree.fronts[f].own.empty()) continue;
        X own = gathered(tree.fronts[f].own, x);
        panels[f].backward(own, gathered(tree.fronts[f].border, x));
        scatter(tree.fronts[f].own, own, x);
        scatter(tree.fronts[f].own, own, result);
    }
    return result;
}

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
    for (const Panel& panel : panels_->panels)
        count += std::size_t(panel.triangle.size() + panel.below.size());
    return count;
}

std::vector<double> FrontalCholesky::solve(std::span<const double> right_sides, int columns) const {
    BEAD_EXPECTS(!panels_->singular);
    BEAD_EXPECTS(right_sides.size() == panels_->held.size() * std::size_t(columns));
    const Eigen::Map<const MatrixXd> given(right_sides.data(), Index(panels_->held.size()),
                                           columns);
    std::vector<double> answer(right_sides.size());
    Eigen::Map<MatrixXd> result(answer.data(), given.rows(), columns);
    if (columns == 1)
        result = panels_->solved(VectorXd(given));
    else
        result = panels_->solved(MatrixXd(given));
    return answer;
}

}  // namespace bead
