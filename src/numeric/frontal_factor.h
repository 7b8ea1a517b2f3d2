// The factor L of K = L Lᵀ, front by front (numeric/frontal_cholesky.h): what the factorisation
// leaves and what the solution reads. Memory: the numbers of L once, and while it is being made the
// remainders that still wait for their parents.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "numeric/elimination.h"
#include "numeric/panel_kernels.h"

namespace bead {

// Adds nothing, fills: the element's symmetric matrix, row by row; unknowns are ordered by point,
// then by component.
using ElementMatrix = std::function<void(std::size_t element, std::span<double> matrix)>;

struct FrontalFactor {
    EliminationTree tree;
    std::vector<std::uint8_t> held;       // unknowns that stay 0
    std::unique_ptr<double[]> panels;     // of one front after the other
    std::vector<std::size_t> begin;       // of each front's panel, and where the last ends
    std::vector<std::size_t> order;       // the points as they are eliminated
    std::vector<std::size_t> borders;     // of one front after the other: places in that order
    std::optional<std::size_t> singular;  // an unknown at which K is not positive definite

    [[nodiscard]] DensePanel panel(std::size_t front) const {
        const Front& f = tree.fronts[front];
        const std::ptrdiff_t block = tree.pattern.unknowns_per_point;
        return {&panels[begin[front]], std::ptrdiff_t(f.own.size()) * block,
                std::ptrdiff_t(f.border.size()) * block};
    }
};

FrontalFactor frontal_factor(EliminationTree tree, const ElementMatrix& matrix,
                             std::span<const std::uint8_t> held);

// Calls `use` with the number of unknowns per point (1 to 3) as a constant, for loops that are then
// unrolled.
template <typename Use>
void with_block(int unknowns_per_point, const Use& use) {
    if (unknowns_per_point == 1)
        use(std::integral_constant<std::ptrdiff_t, 1>{});
    else if (unknowns_per_point == 2)
        use(std::integral_constant<std::ptrdiff_t, 2>{});
    else
        use(std::integral_constant<std::ptrdiff_t, 3>{});
}

}  // namespace bead
