// Products of tall, narrow matrices, column by column in memory, a few rows at a time so that both
// stay in the cache: what orthogonalising a block of vectors against a basis takes. A general
// matrix product would spend its time on packing. The sums are taken in the same order on every
// processor.
#pragma once
#include <cstddef>

namespace bead {

struct TallMatrix {
    const double* values = nullptr;
    std::ptrdiff_t rows = 0, columns = 0;
};

// h = vᵀ x, v.columns × x.columns, column by column.
void inner_products(const TallMatrix& v, const TallMatrix& x, double* h);
// x -= v h, x of `columns` columns.
void take_out(const TallMatrix& v, const double* h, double* x, std::ptrdiff_t columns);

}  // namespace bead
