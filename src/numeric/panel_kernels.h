// The inner loops of solving with a dense lower triangle and the rows below it, for one right side
// or for eight at once: then the values of an unknown lie side by side, so that each number of the
// panel is read once for all of them. Reading the panel is what takes the time, so its numbers lie
// in the order in which they are read. Where the processor has wide registers they are used; the
// sums are taken in the same order, for one side as for eight, so the bits are the same.
#pragma once
#include <algorithm>
#include <cstddef>

namespace bead {

inline constexpr std::ptrdiff_t panel_width = 8;  // right sides at once
inline constexpr std::ptrdiff_t strip_width = 4;  // columns that go together

// The columns of L of `own` unknowns, in strips of four, the last one of what is left: of each
// strip the rows from its first column down, those of `own` unknowns, then those of the border; of
// each row the strip's numbers side by side. What lies above the diagonal is there and not read.
struct DensePanel {
    const double* values = nullptr;
    std::ptrdiff_t own = 0, border = 0;
};

// Calls visit(first column, columns, rows) for each strip, in order.
template <typename Visit>
void for_strips(std::ptrdiff_t own, std::ptrdiff_t border, const Visit& visit) {
    for (std::ptrdiff_t j = 0; j < own; j += strip_width)
        visit(j, std::min(strip_width, own - j), own + border - j);
}

// Numbers in a panel.
inline std::ptrdiff_t panel_size(std::ptrdiff_t own, std::ptrdiff_t border) {
    std::ptrdiff_t size = 0;
    for_strips(own, border,
               [&](auto, std::ptrdiff_t columns, std::ptrdiff_t rows) { size += columns * rows; });
    return size;
}

// own = L^-1 own, border -= B own, B the rows below. `sides`: 1 or `panel_width`, numbers per row.
void solve_forward(const DensePanel& panel, std::ptrdiff_t sides, double* own, double* border);
// own = L^-T (own - Bᵀ border).
void solve_backward(const DensePanel& panel, std::ptrdiff_t sides, double* own,
                    const double* border);

}  // namespace bead
