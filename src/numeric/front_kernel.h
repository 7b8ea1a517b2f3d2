// The inner loop of a multifrontal factorisation: a dense symmetric matrix of which the first rows
// are eliminated. In place, column by column, the lower half only; what lies above the diagonal is
// neither read nor kept. Blocks of columns are factored, then what lies right of them is updated in
// tiles of eight rows by four columns, which may reach over the rim.
#pragma once
#include <cstddef>

namespace bead {

// From one column of the matrix to the next, with room for the tiles.
constexpr std::ptrdiff_t front_stride(std::ptrdiff_t size) { return size + 7; }

// The first `own` columns become those of L (A = L Lᵀ); the rest of the `size` becomes
// A22 - L21 L21ᵀ. A pivot that is not positive leaves what is not a number.
void eliminate_first(double* matrix, std::ptrdiff_t size, std::ptrdiff_t own);

}  // namespace bead
