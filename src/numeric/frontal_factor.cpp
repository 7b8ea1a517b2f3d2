#include "numeric/frontal_factor.h"

#include <algorithm>

#include "numeric/front_kernel.h"

namespace bead {
namespace {

// A pivot this small against what stood there first is rounding.
constexpr double rounding = 1e-13;

// `b`: unknowns per point.
template <std::ptrdiff_t b>
class Factorisation {
  public:
    Factorisation(FrontalFactor& factor, const ElementMatrix& matrix)
        : factor_(factor), matrix_(matrix), local_(factor.tree.pattern.places.size(), -1) {
        std::size_t most = 0;
        for (const Front& front : factor.tree.fronts) most = std::max(most, rows(front));
        sum_.resize(most * stride(most));
    }

    // Fronts are in postorder: a front's children are the last ones still waiting.
    void run() {
        const std::vector<Front>& fronts = factor_.tree.fronts;
        for (std::size_t f = 0; f < fronts.size() && !factor_.singular; ++f) {
            begin(fronts[f]);
            assemble(fronts[f]);
            for (int c = 0; c < fronts[f].children; ++c) add_last_remainder();
            eliminate(f);
        }
    }

  private:
    static std::size_t rows(const Front& front) {
        return (front.own.size() + front.border.size()) * std::size_t(b);
    }
    static std::size_t stride(std::size_t rows) {
        return std::size_t(front_stride(std::ptrdiff_t(rows)));
    }
    double* column(std::size_t j) { return &sum_[j * stride_]; }

    // Numbers the front's unknowns and clears its lower triangle.
    void begin(const Front& front) {
        int next = 0;
        for (const int point : front.own) local_[std::size_t(point)] = next++ * int(b);
        for (const int point : front.border) local_[std::size_t(point)] = next++ * int(b);
        size_ = rows(front);
        stride_ = stride(size_);
        for (std::size_t j = 0; j < size_; ++j) std::fill_n(column(j) + j, stride_ - j, 0.0);
    }

    void assemble(const Front& front) {
        const ElementPattern& pattern = factor_.tree.pattern;
        const auto count = std::size_t(pattern.points_per_element);
        const std::size_t side = count * std::size_t(b);
        values_.resize(side * side);
        for (const int element : front.elements) {
            matrix_(std::size_t(element), values_);
            const std::span<const int> points =
                std::span(pattern.points).subspan(std::size_t(element) * count, count);
            for (std::size_t q = 0; q < count; ++q)
                for (std::size_t p = 0; p < count; ++p)
                    if (local_[std::size_t(points[p])] >= local_[std::size_t(points[q])])
                        add_pair(points[p], points[q], &values_[(q * side + p) * std::size_t(b)],
                                 side);
        }
        for (const int point : front.own)
            for (std::size_t c = 0; c < std::size_t(b); ++c)
                if (held(point, c)) {
                    const std::size_t at = std::size_t(local_[std::size_t(point)]) + c;
                    column(at)[at] = 1;
                }
    }

    // Of an element's matrix the rows of point p in the columns of point q.
    void add_pair(int p, int q, const double* values, std::size_t side) {
        const auto row = std::size_t(local_[std::size_t(p)]);
        const auto to = std::size_t(local_[std::size_t(q)]);
        for (std::size_t c = 0; c < std::size_t(b); ++c) {
            if (held(q, c)) continue;
            double* const sums = column(to + c) + row;
            for (std::size_t r = p == q ? c : 0; r < std::size_t(b); ++r)
                if (!held(p, r)) sums[r] += values[c * side + r];
        }
    }

    bool held(int point, std::size_t component) const {
        return factor_.held[std::size_t(point) * std::size_t(b) + component] != 0;
    }

    void add_last_remainder() {
        const std::vector<int>& border = factor_.tree.fronts[waiting_.back()].border;
        waiting_.pop_back();
        const std::size_t side = border.size() * std::size_t(b);
        const std::size_t first = remainders_.size() - side * (side + 1) / 2;
        const double* next = remainders_.data() + first;
        at_.clear();
        for (const int point : border) at_.push_back(std::size_t(local_[std::size_t(point)]));
        for (std::size_t q = 0; q < at_.size(); ++q)
            for (std::size_t c = 0; c < std::size_t(b); ++c) {
                double* const sums = column(at_[q] + c);
                for (std::size_t r = c; r < std::size_t(b); ++r) sums[at_[q] + r] += *next++;
                for (std::size_t p = q + 1; p < at_.size(); ++p)
                    for (std::size_t r = 0; r < std::size_t(b); ++r) sums[at_[p] + r] += *next++;
            }
        remainders_.resize(first);
    }

    // Puts the numbers of each row side by side.
    [[gnu::always_inline]] void keep(const double* from, std::ptrdiff_t columns,
                                     std::ptrdiff_t rows, double* to) const {
        const auto stride = std::ptrdiff_t(stride_);
        for (std::ptrdiff_t i = 0; i < rows; ++i)
            for (std::ptrdiff_t j = 0; j < columns; ++j) to[i * columns + j] = from[j * stride + i];
    }

    // Factors the own part; what is left waits for the parent.
    void eliminate(std::size_t place) {
        const Front& front = factor_.tree.fronts[place];
        const std::size_t own = front.own.size() * std::size_t(b);
        before_.clear();
        for (std::size_t i = 0; i < own; ++i) before_.push_back(column(i)[i]);
        if (own > 0)  // 0: halves that do not touch
            eliminate_first(sum_.data(), std::ptrdiff_t(size_), std::ptrdiff_t(own));
        for (std::size_t i = 0; i < own && !factor_.singular; ++i)
            if (const double root = column(i)[i]; !(root * root > rounding * before_[i]))
                factor_.singular = std::size_t(front.own[i / std::size_t(b)]) * std::size_t(b) +
                                   i % std::size_t(b);
        double* kept = &factor_.panels[factor_.begin[place]];
        for_strips(std::ptrdiff_t(own), std::ptrdiff_t(size_ - own),
                   [&](std::ptrdiff_t first, std::ptrdiff_t columns, std::ptrdiff_t rows) {
                       const double* const from = column(std::size_t(first)) + first;
                       if (columns == strip_width)
                           keep(from, strip_width, rows, kept);
                       else
                           keep(from, columns, rows, kept);
                       kept += columns * rows;
                   });
        for (std::size_t j = own; j < size_; ++j)
            remainders_.insert(remainders_.end(), column(j) + j, column(j) + size_);
        waiting_.push_back(place);
    }

    FrontalFactor& factor_;
    const ElementMatrix& matrix_;
    std::vector<int> local_;             // a point's first row in the front
    std::vector<double> sum_;            // the front, column by column, the lower triangle
    std::size_t size_ = 0, stride_ = 0;  // rows of the front, and from column to column
    std::vector<double> values_;         // of an element's matrix
    std::vector<double> before_;         // what stood on the diagonal
    std::vector<std::size_t> waiting_;   // fronts without a parent yet
    std::vector<double> remainders_;     // theirs, lower triangles column by column
    std::vector<std::size_t> at_;        // rows of a remainder's points
};

// Where the points of each front are in the order of elimination.
void find_places(FrontalFactor& factor) {
    for (const Front& front : factor.tree.fronts)
        for (const int point : front.own) factor.order.push_back(std::size_t(point));
    std::vector<std::size_t> place(factor.tree.pattern.places.size());
    for (std::size_t i = 0; i < factor.order.size(); ++i) place[factor.order[i]] = i;
    for (const Front& front : factor.tree.fronts)
        for (const int point : front.border) factor.borders.push_back(place[std::size_t(point)]);
}

}  // namespace

FrontalFactor frontal_factor(EliminationTree tree, const ElementMatrix& matrix,
                             std::span<const std::uint8_t> held) {
    FrontalFactor factor{std::move(tree), {held.begin(), held.end()}, nullptr, {}, {}, {}, {}};
    find_places(factor);
    const auto block = std::size_t(factor.tree.pattern.unknowns_per_point);
    std::size_t end = 0;
    for (const Front& front : factor.tree.fronts) {
        factor.begin.push_back(end);
        end += std::size_t(panel_size(std::ptrdiff_t(front.own.size() * block),
                                      std::ptrdiff_t(front.border.size() * block)));
    }
    factor.begin.push_back(end);
    factor.panels = std::make_unique_for_overwrite<double[]>(end);
    with_block(int(block), [&](auto b) { Factorisation<b()>(factor, matrix).run(); });
    return factor;
}

}  // namespace bead
