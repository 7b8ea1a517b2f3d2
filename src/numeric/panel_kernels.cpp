#include "numeric/panel_kernels.h"

#include "numeric/lanes.h"
#include "numeric/wide_registers.h"

namespace bead {
namespace {

using Index = std::ptrdiff_t;

// The panel is fetched before it is needed, for the processor does not foresee strips that are read
// backwards: forward this many numbers before, backward a strip.
constexpr Index ahead = 256;

// Of an unknown the values of eight right sides, in two halves, each of which fits a wide register.
struct Eight {
    Lanes low, high;

    [[gnu::always_inline]] static Eight row(const double* rows, Index i) {
        const double* const at = rows + i * panel_width;
        return {*lanes(at), *lanes(at + 4)};
    }
    [[gnu::always_inline]] static void put(double* rows, Index i, const Eight& r) {
        double* const at = rows + i * panel_width;
        *lanes(at) = r.low;
        *lanes(at + 4) = r.high;
    }
};

[[gnu::always_inline]] inline Eight operator*(double a, const Eight& r) {
    return {a * r.low, a * r.high};
}
[[gnu::always_inline]] inline Eight operator/(const Eight& r, double a) {
    return {r.low / a, r.high / a};
}
[[gnu::always_inline]] inline Eight operator-(const Eight& a, const Eight& b) {
    return {a.low - b.low, a.high - b.high};
}

// That of one right side.
struct One {
    double value;

    [[gnu::always_inline]] static One row(const double* rows, Index i) { return {rows[i]}; }
    [[gnu::always_inline]] static void put(double* rows, Index i, One r) { rows[i] = r.value; }
};

[[gnu::always_inline]] inline One operator*(double a, One r) { return {a * r.value}; }
[[gnu::always_inline]] inline One operator/(One r, double a) { return {r.value / a}; }
[[gnu::always_inline]] inline One operator-(One a, One b) { return {a.value - b.value}; }

template <typename Row>
[[gnu::always_inline]] inline void forward(const DensePanel& panel, double* own, double* border) {
    const Index n = panel.own, m = panel.border;
    const double* a = panel.values;
    Index j = 0;
    for (; j + 4 <= n; j += 4) {
        const Row x = Row::row(own, j) / a[0];
        const Row y = (Row::row(own, j + 1) - a[4] * x) / a[5];
        const Row z = (Row::row(own, j + 2) - a[8] * x - a[9] * y) / a[10];
        const Row w = (Row::row(own, j + 3) - a[12] * x - a[13] * y - a[14] * z) / a[15];
        Row::put(own, j, x);
        Row::put(own, j + 1, y);
        Row::put(own, j + 2, z);
        Row::put(own, j + 3, w);
        a += 16;
        for (Index i = j + 4; i < n; ++i, a += 4) {
            __builtin_prefetch(a + ahead);
            Row::put(own, i, Row::row(own, i) - a[0] * x - a[1] * y - a[2] * z - a[3] * w);
        }
        for (Index i = 0; i < m; ++i, a += 4) {
            __builtin_prefetch(a + ahead);
            Row::put(border, i, Row::row(border, i) - a[0] * x - a[1] * y - a[2] * z - a[3] * w);
        }
    }
    const Index rest = n - j;
    for (Index c = 0; c < rest; ++c) {
        const Row x = Row::row(own, j + c) / a[c * rest + c];
        Row::put(own, j + c, x);
        for (Index i = c + 1; i < rest; ++i)
            Row::put(own, j + i, Row::row(own, j + i) - a[i * rest + c] * x);
        for (Index i = 0; i < m; ++i)
            Row::put(border, i, Row::row(border, i) - a[(rest + i) * rest + c] * x);
    }
}

template <typename Row>
[[gnu::always_inline]] inline void backward(const DensePanel& panel, double* own,
                                            const double* border) {
    const Index n = panel.own, m = panel.border, rest = n % 4;
    Index j = n - rest;
    const double* a = panel.values + panel_size(n, m) - rest * (rest + m);
    for (Index c = rest; c-- > 0;) {
        Row x = Row::row(own, j + c);
        for (Index i = 0; i < m; ++i) x = x - a[(rest + i) * rest + c] * Row::row(border, i);
        for (Index i = c + 1; i < rest; ++i) x = x - a[i * rest + c] * Row::row(own, j + i);
        Row::put(own, j + c, x / a[c * rest + c]);
    }
    while (j > 0) {
        j -= 4;
        a -= 4 * (n + m - j);
        Row x = Row::row(own, j), y = Row::row(own, j + 1);
        Row z = Row::row(own, j + 2), w = Row::row(own, j + 3);
        const double* p = a + 4 * (n - j);
        const Index before = 4 * (n + m - j + 4);
        for (Index i = 0; i < m; ++i, p += 4) {
            __builtin_prefetch(p - before);
            const Row e = Row::row(border, i);
            x = x - p[0] * e;
            y = y - p[1] * e;
            z = z - p[2] * e;
            w = w - p[3] * e;
        }
        p = a + 16;
        for (Index i = j + 4; i < n; ++i, p += 4) {
            __builtin_prefetch(p - before);
            const Row e = Row::row(own, i);
            x = x - p[0] * e;
            y = y - p[1] * e;
            z = z - p[2] * e;
            w = w - p[3] * e;
        }
        w = w / a[15];
        z = (z - a[14] * w) / a[10];
        y = (y - a[13] * w - a[9] * z) / a[5];
        x = (x - a[12] * w - a[8] * z - a[4] * y) / a[0];
        Row::put(own, j, x);
        Row::put(own, j + 1, y);
        Row::put(own, j + 2, z);
        Row::put(own, j + 3, w);
    }
}

}  // namespace

BEAD_WIDE_REGISTERS
void solve_forward(const DensePanel& panel, std::ptrdiff_t sides, double* own, double* border) {
    if (sides == 1)
        forward<One>(panel, own, border);
    else
        forward<Eight>(panel, own, border);
}

BEAD_WIDE_REGISTERS
void solve_backward(const DensePanel& panel, std::ptrdiff_t sides, double* own,
                    const double* border) {
    if (sides == 1)
        backward<One>(panel, own, border);
    else
        backward<Eight>(panel, own, border);
}

}  // namespace bead
