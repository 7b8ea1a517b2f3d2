#include "numeric/tall_products.h"

#include <algorithm>

#include "numeric/lanes.h"
#include "numeric/wide_registers.h"

namespace bead {
namespace {

using Index = std::ptrdiff_t;

constexpr Index at_once = 4;
constexpr Index rows_at_a_time = 512;

[[gnu::always_inline]] inline double sum(const Lanes& v) { return (v[0] + v[1]) + (v[2] + v[3]); }

// Two columns of v by four of x.
[[gnu::always_inline]] inline void add_inner(const double* v, const double* x, Index stride,
                                             Index rows, double* h, Index height) {
    const double *const v0 = v, *const v1 = v + stride;
    const double *const x0 = x, *const x1 = x0 + stride, *const x2 = x1 + stride,
                        *const x3 = x2 + stride;
    Lanes a0{}, a1{}, a2{}, a3{}, b0{}, b1{}, b2{}, b3{};
    for (Index i = 0; i < rows; i += at_once) {
        const Lanes p = *lanes(v0 + i), q = *lanes(v1 + i);
        const Lanes c0 = *lanes(x0 + i), c1 = *lanes(x1 + i), c2 = *lanes(x2 + i),
                    c3 = *lanes(x3 + i);
        a0 += p * c0;
        a1 += p * c1;
        a2 += p * c2;
        a3 += p * c3;
        b0 += q * c0;
        b1 += q * c1;
        b2 += q * c2;
        b3 += q * c3;
    }
    h[0] += sum(a0);
    h[height] += sum(a1);
    h[2 * height] += sum(a2);
    h[3 * height] += sum(a3);
    h[1] += sum(b0);
    h[height + 1] += sum(b1);
    h[2 * height + 1] += sum(b2);
    h[3 * height + 1] += sum(b3);
}

// Two columns of v out of four of x.
[[gnu::always_inline]] inline void reduce(const double* v, Index stride, Index rows,
                                          const double* h, Index height, double* x) {
    const double *const v0 = v, *const v1 = v + stride;
    double *const x0 = x, *const x1 = x0 + stride, *const x2 = x1 + stride, *const x3 = x2 + stride;
    for (Index i = 0; i < rows; i += at_once) {
        const Lanes p = *lanes(v0 + i), q = *lanes(v1 + i);
        *lanes(x0 + i) = *lanes(x0 + i) - h[0] * p - h[1] * q;
        *lanes(x1 + i) = *lanes(x1 + i) - h[height] * p - h[height + 1] * q;
        *lanes(x2 + i) = *lanes(x2 + i) - h[2 * height] * p - h[2 * height + 1] * q;
        *lanes(x3 + i) = *lanes(x3 + i) - h[3 * height] * p - h[3 * height + 1] * q;
    }
}

// Whatever does not fit the tiles above.
void add_inner_rest(const TallMatrix& v, const TallMatrix& x, Index first, Index rows, Index j,
                    Index k, double* h) {
    double total = 0;
    for (Index i = first; i < first + rows; ++i)
        total += v.values[j * v.rows + i] * x.values[k * x.rows + i];
    h[k * v.columns + j] += total;
}

}  // namespace

BEAD_WIDE_REGISTERS
void inner_products(const TallMatrix& v, const TallMatrix& x, double* h) {
    std::fill(h, h + v.columns * x.columns, 0.0);
    for (Index first = 0; first < v.rows; first += rows_at_a_time) {
        const Index rows = std::min(rows_at_a_time, v.rows - first),
                    even = rows / at_once * at_once;
        for (Index j = 0; j < v.columns; j += 2)
            for (Index k = 0; k < x.columns; k += 4) {
                const bool fits = j + 2 <= v.columns && k + 4 <= x.columns;
                if (fits)
                    add_inner(v.values + j * v.rows + first, x.values + k * x.rows + first, v.rows,
                              even, h + k * v.columns + j, v.columns);
                const Index done = fits ? even : 0;
                if (done == rows) continue;
                for (Index l = k; l < std::min(k + 4, x.columns); ++l)
                    for (Index i = j; i < std::min(j + 2, v.columns); ++i)
                        add_inner_rest(v, x, first + done, rows - done, i, l, h);
            }
    }
}

BEAD_WIDE_REGISTERS
void take_out(const TallMatrix& v, const double* h, double* x, Index columns) {
    for (Index first = 0; first < v.rows; first += rows_at_a_time) {
        const Index rows = std::min(rows_at_a_time, v.rows - first),
                    even = rows / at_once * at_once;
        for (Index k = 0; k < columns; k += 4)
            for (Index j = 0; j < v.columns; j += 2) {
                const bool fits = j + 2 <= v.columns && k + 4 <= columns;
                if (fits)
                    reduce(v.values + j * v.rows + first, v.rows, even, h + k * v.columns + j,
                           v.columns, x + k * v.rows + first);
                const Index done = fits ? even : 0;
                for (Index l = k; l < std::min(k + 4, columns); ++l)
                    for (Index i = j; i < std::min(j + 2, v.columns); ++i)
                        for (Index r = first + done; r < first + rows; ++r)
                            x[l * v.rows + r] -= v.values[i * v.rows + r] * h[l * v.columns + i];
            }
    }
}

}  // namespace bead
