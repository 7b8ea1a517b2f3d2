// The inner loops of solving with a dense lower triangle and the rows below it, for eight right
// sides at once: the values of an unknown lie side by side, so that each number of the panel is
// read once for all of them. Four columns of the panel go together. Where the processor has wider
// registers they are used; the sums are taken in the same order, so the bits are the same.
#pragma once
#include <cstddef>

namespace bead {

inline constexpr std::ptrdiff_t panel_width = 8;

// The columns of L of `own` unknowns, one after the other, each with the rows of all `own` and
// `border` unknowns; what lies above the diagonal is not read.
struct DensePanel {
    const double* values = nullptr;
    std::ptrdiff_t own = 0, border = 0;
};

// own = L^-1 own, border -= B own, B the rows below; both `panel_width` numbers per row.
void solve_forward(const DensePanel& panel, double* own, double* border);
// own = L^-T (own - Bᵀ border).
void solve_backward(const DensePanel& panel, double* own, const double* border);
// The same for one right side.
void solve_one_forward(const DensePanel& panel, double* own, double* border);
void solve_one_backward(const DensePanel& panel, double* own, const double* border);

}  // namespace bead
