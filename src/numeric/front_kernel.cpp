#include "numeric/front_kernel.h"

#include <algorithm>
#include <cmath>

#include "numeric/lanes.h"
#include "numeric/wide_registers.h"

namespace bead {
namespace {

using Index = std::ptrdiff_t;

constexpr Index block = 48;  // columns that are factored before the rest is updated
constexpr Index tile_rows = 8, tile_columns = 4;

[[gnu::always_inline]] inline void subtract(double* at, const Lanes& values) {
    Lanes& kept = *reinterpret_cast<Lanes*>(at);
    kept = kept - values;
}

// A(i … i+7, j … j+3) -= the sum over k of A(i …, k) A(j …, k).
[[gnu::always_inline]] inline void update_tile(double* a, Index size, Index i, Index j, Index from,
                                               Index to) {
    Lanes p0{}, p1{}, p2{}, p3{}, q0{}, q1{}, q2{}, q3{};
    const double *left = a + from * size + i, *right = a + from * size + j;
    for (Index k = from; k < to; ++k, left += size, right += size) {
        const Lanes p = load(left), q = load(left + 4);
        p0 += right[0] * p;
        q0 += right[0] * q;
        p1 += right[1] * p;
        q1 += right[1] * q;
        p2 += right[2] * p;
        q2 += right[2] * q;
        p3 += right[3] * p;
        q3 += right[3] * q;
    }
    double* const c = a + j * size + i;
    subtract(c, p0);
    subtract(c + 4, q0);
    subtract(c + size, p1);
    subtract(c + size + 4, q1);
    subtract(c + 2 * size, p2);
    subtract(c + 2 * size + 4, q2);
    subtract(c + 3 * size, p3);
    subtract(c + 3 * size + 4, q3);
}

[[gnu::always_inline]] inline void update_entries(double* a, Index size, Index i0, Index i1,
                                                  Index j0, Index j1, Index from, Index to) {
    for (Index j = j0; j < j1; ++j)
        for (Index i = std::max(i0, j); i < i1; ++i) {
            double sum = 0;
            for (Index k = from; k < to; ++k) sum += a[k * size + i] * a[k * size + j];
            a[j * size + i] -= sum;
        }
}

// Columns first … last-1, from the diagonal down, less the columns from … to-1.
[[gnu::always_inline]] inline void update(double* a, Index size, Index first, Index last,
                                          Index from, Index to) {
    for (Index i = first; i < size; i += tile_rows) {
        const Index end = std::min(i + tile_rows, size), columns = std::min(last, end);
        for (Index j = first; j < columns; j += tile_columns)
            if (end == i + tile_rows && j + tile_columns <= last)
                update_tile(a, size, i, j, from, to);
            else
                update_entries(a, size, i, end, j, std::min(j + tile_columns, columns), from, to);
    }
}

[[gnu::always_inline]] inline void factor_columns(double* a, Index size, Index first, Index last) {
    for (Index j = first; j < last; ++j) {
        double* const column = a + j * size;
        const double pivot = std::sqrt(column[j]);
        column[j] = pivot;
        for (Index i = j + 1; i < size; ++i) column[i] /= pivot;
        for (Index k = j + 1; k < last; ++k) {
            const double factor = column[k];
            double* const next = a + k * size;
            for (Index i = k; i < size; ++i) next[i] -= factor * column[i];
        }
    }
}

}  // namespace

BEAD_WIDE_REGISTERS
void eliminate_first(double* matrix, std::ptrdiff_t size, std::ptrdiff_t own) {
    for (Index first = 0; first < own; first += block) {
        const Index last = std::min(first + block, own);
        for (Index j = first; j < last; j += tile_columns) {
            const Index end = std::min(j + tile_columns, last);
            if (j > first) update(matrix, size, j, end, first, j);
            factor_columns(matrix, size, j, end);
        }
        if (last < size) update(matrix, size, last, size, first, last);
    }
}

}  // namespace bead
