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
    *lanes(at) = *lanes(at) - values;
}

// A(i … i+7, j … j+3) -= the sum over k of A(i …, k) A(j …, k).
[[gnu::always_inline]] inline void update_tile(double* a, Index stride, Index i, Index j,
                                               Index from, Index to) {
    Lanes p0{}, p1{}, p2{}, p3{}, q0{}, q1{}, q2{}, q3{};
    const double *left = a + from * stride + i, *right = a + from * stride + j;
    for (Index k = from; k < to; ++k, left += stride, right += stride) {
        const Lanes p = *lanes(left), q = *lanes(left + 4);
        p0 += right[0] * p;
        q0 += right[0] * q;
        p1 += right[1] * p;
        q1 += right[1] * q;
        p2 += right[2] * p;
        q2 += right[2] * q;
        p3 += right[3] * p;
        q3 += right[3] * q;
    }
    double* const c = a + j * stride + i;
    subtract(c, p0);
    subtract(c + 4, q0);
    subtract(c + stride, p1);
    subtract(c + stride + 4, q1);
    subtract(c + 2 * stride, p2);
    subtract(c + 2 * stride + 4, q2);
    subtract(c + 3 * stride, p3);
    subtract(c + 3 * stride + 4, q3);
}

// Fewer than four columns: j … j1-1, rows i … i+7.
[[gnu::always_inline]] inline void update_columns(double* a, Index stride, Index i, Index j,
                                                  Index j1, Index from, Index to) {
    for (; j < j1; ++j) {
        Lanes p{}, q{};
        for (Index k = from; k < to; ++k) {
            const double* const column = a + k * stride;
            p += column[j] * *lanes(column + i);
            q += column[j] * *lanes(column + i + 4);
        }
        subtract(a + j * stride + i, p);
        subtract(a + j * stride + i + 4, q);
    }
}

// Columns first … last-1, from the diagonal down, less the columns from … to-1.
[[gnu::always_inline]] inline void update(double* a, Index stride, Index size, Index first,
                                          Index last, Index from, Index to) {
    for (Index i = first; i < size; i += tile_rows) {
        const Index columns = std::min(last, i + tile_rows);
        for (Index j = first; j < columns; j += tile_columns)
            if (j + tile_columns <= last)
                update_tile(a, stride, i, j, from, to);
            else
                update_columns(a, stride, i, j, last, from, to);
    }
}

[[gnu::always_inline]] inline void factor_columns(double* a, Index stride, Index size, Index first,
                                                  Index last) {
    for (Index j = first; j < last; ++j) {
        double* const column = a + j * stride;
        const double pivot = std::sqrt(column[j]);
        column[j] = pivot;
        for (Index i = j + 1; i < size; ++i) column[i] /= pivot;
        for (Index k = j + 1; k < last; ++k) {
            const double factor = column[k];
            double* const next = a + k * stride;
            for (Index i = k; i < size; ++i) next[i] -= factor * column[i];
        }
    }
}

}  // namespace

BEAD_WIDE_REGISTERS
void eliminate_first(double* matrix, std::ptrdiff_t size, std::ptrdiff_t own) {
    const Index stride = front_stride(size);
    for (Index first = 0; first < own; first += block) {
        const Index last = std::min(first + block, own);
        for (Index j = first; j < last; j += tile_columns) {
            const Index end = std::min(j + tile_columns, last);
            if (j > first) update(matrix, stride, size, j, end, first, j);
            factor_columns(matrix, stride, size, j, end);
        }
        if (last < size) update(matrix, stride, size, last, size, first, last);
    }
}

}  // namespace bead
