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
#include <optional>
#include <span>
#include <vector>

#include "numeric/frontal_factor.h"

namespace bead {

class FrontalCholesky {
  public:
    // `held`: unknowns that stay 0, one per unknown (unknowns_per_point * point + component).
    FrontalCholesky(EliminationTree tree, const ElementMatrix& matrix,
                    std::span<const std::uint8_t> held);

    // An unknown at which K is not positive definite to rounding; the factor is then useless.
    [[nodiscard]] std::optional<std::size_t> singular() const;
    [[nodiscard]] std::size_t fill() const;  // numbers kept

    // Held unknowns, and those of points in no element, come out 0.
    // Several right sides, one after the other, cost little more than one.
    [[nodiscard]] std::vector<double> solve(std::span<const double> right_sides,
                                            int columns = 1) const;

  private:
    FrontalFactor factor_;
};

}  // namespace bead
