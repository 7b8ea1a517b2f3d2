// Direct solution of K x = b where K is a sum of small dense symmetric matrices over elements, by
// the multifrontal method (Duff and Reid 1983): along the elimination tree every front is a small
// dense matrix that is added up from its elements and its children's remainders, partly factored,
// and handed on. K is never put together. All arithmetic is on dense blocks.
//
//     const FrontalCholesky factor(elimination_tree(pattern), matrix, held);
//     const std::vector<double> x = factor.solve(b);
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "numeric/elimination.h"

namespace bead {

// Adds nothing, fills: the element's symmetric matrix, row by row; unknowns are ordered by point,
// then by component.
using ElementMatrix = std::function<void(std::size_t element, std::span<double> matrix)>;

class FrontalCholesky {
  public:
    // `held`: unknowns that stay 0, one per unknown (unknowns_per_point * point + component).
    FrontalCholesky(EliminationTree tree, const ElementMatrix& matrix,
                    std::span<const std::uint8_t> held);
    FrontalCholesky(FrontalCholesky&&) noexcept;
    FrontalCholesky& operator=(FrontalCholesky&&) noexcept;
    ~FrontalCholesky();

    // An unknown at which K is not positive definite to rounding; the factor is then useless.
    [[nodiscard]] std::optional<std::size_t> singular() const;
    [[nodiscard]] std::size_t fill() const;  // numbers kept

    // Held unknowns, and those of points in no element, come out 0.
    // Several right sides, one after the other, cost little more than one.
    [[nodiscard]] std::vector<double> solve(std::span<const double> right_sides,
                                            int columns = 1) const;

  private:
    struct Panels;
    template <std::ptrdiff_t width>
    class Sweep;
    std::unique_ptr<Panels> panels_;
};

}  // namespace bead
