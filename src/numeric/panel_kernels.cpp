#include "numeric/panel_kernels.h"

#include "numeric/lanes.h"
#include "numeric/wide_registers.h"

namespace bead {
namespace {

using Index = std::ptrdiff_t;

constexpr Index width = panel_width;

// Eight numbers in two halves, each of which fits a wide register.
struct PanelRow {
    Lanes low, high;
};

[[gnu::always_inline]] inline PanelRow row(const double* rows, Index i) {
    const Lanes* const at = reinterpret_cast<const Lanes*>(rows + i * width);
    return {at[0], at[1]};
}
[[gnu::always_inline]] inline void put(double* rows, Index i, const PanelRow& r) {
    Lanes* const at = reinterpret_cast<Lanes*>(rows + i * width);
    at[0] = r.low;
    at[1] = r.high;
}
[[gnu::always_inline]] inline PanelRow operator*(double a, const PanelRow& r) {
    return {a * r.low, a * r.high};
}
[[gnu::always_inline]] inline PanelRow operator/(const PanelRow& r, double a) {
    return {r.low / a, r.high / a};
}
[[gnu::always_inline]] inline PanelRow operator-(const PanelRow& a, const PanelRow& b) {
    return {a.low - b.low, a.high - b.high};
}
[[gnu::always_inline]] inline void operator-=(PanelRow& a, const PanelRow& b) { a = a - b; }

// Four partial sums side by side.
[[gnu::always_inline]] inline double dot_product(const double* a, const double* b, Index count) {
    double sums[4] = {0, 0, 0, 0};
    Index i = 0;
    for (; i + 4 <= count; i += 4)
        for (Index k = 0; k < 4; ++k) sums[k] += a[i + k] * b[i + k];
    for (; i < count; ++i) sums[0] += a[i] * b[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

BEAD_WIDE_REGISTERS
void solve_forward(const DensePanel& panel, double* own, double* border) {
    const Index n = panel.own, m = panel.border, size = n + m;
    Index j = 0;
    for (; j + 4 <= n; j += 4) {
        const double* const a = panel.values + j * size;
        const double *const b = a + size, *const c = b + size, *const d = c + size;
        const PanelRow x = row(own, j) / a[j];
        const PanelRow y = (row(own, j + 1) - a[j + 1] * x) / b[j + 1];
        const PanelRow z = (row(own, j + 2) - a[j + 2] * x - b[j + 2] * y) / c[j + 2];
        const PanelRow w =
            (row(own, j + 3) - a[j + 3] * x - b[j + 3] * y - c[j + 3] * z) / d[j + 3];
        put(own, j, x);
        put(own, j + 1, y);
        put(own, j + 2, z);
        put(own, j + 3, w);
        for (Index i = j + 4; i < n; ++i)
            put(own, i, row(own, i) - a[i] * x - b[i] * y - c[i] * z - d[i] * w);
        const double *const p = a + n, *const q = b + n, *const r = c + n, *const s = d + n;
        for (Index i = 0; i < m; ++i)
            put(border, i, row(border, i) - p[i] * x - q[i] * y - r[i] * z - s[i] * w);
    }
    for (; j < n; ++j) {
        const double* const a = panel.values + j * size;
        const PanelRow x = row(own, j) / a[j];
        put(own, j, x);
        for (Index i = j + 1; i < n; ++i) put(own, i, row(own, i) - a[i] * x);
        const double* const p = a + n;
        for (Index i = 0; i < m; ++i) put(border, i, row(border, i) - p[i] * x);
    }
}

BEAD_WIDE_REGISTERS
void solve_backward(const DensePanel& panel, double* own, const double* border) {
    const Index n = panel.own, m = panel.border, size = n + m;
    Index j = n;
    for (; j % 4 != 0; --j) {
        const double* const a = panel.values + (j - 1) * size;
        const double* const p = a + n;
        PanelRow x = row(own, j - 1);
        for (Index i = 0; i < m; ++i) x -= p[i] * row(border, i);
        for (Index i = j; i < n; ++i) x -= a[i] * row(own, i);
        put(own, j - 1, x / a[j - 1]);
    }
    for (; j > 0; j -= 4) {
        const Index f = j - 4;
        const double* const a = panel.values + f * size;
        const double *const b = a + size, *const c = b + size, *const d = c + size;
        const double *const p = a + n, *const q = b + n, *const r = c + n, *const s = d + n;
        PanelRow x = row(own, f), y = row(own, f + 1), z = row(own, f + 2), w = row(own, f + 3);
        for (Index i = 0; i < m; ++i) {
            const PanelRow e = row(border, i);
            x -= p[i] * e;
            y -= q[i] * e;
            z -= r[i] * e;
            w -= s[i] * e;
        }
        for (Index i = j; i < n; ++i) {
            const PanelRow e = row(own, i);
            x -= a[i] * e;
            y -= b[i] * e;
            z -= c[i] * e;
            w -= d[i] * e;
        }
        w = w / d[f + 3];
        z = (z - c[f + 3] * w) / c[f + 2];
        y = (y - b[f + 3] * w - b[f + 2] * z) / b[f + 1];
        x = (x - a[f + 3] * w - a[f + 2] * z - a[f + 1] * y) / a[f];
        put(own, f, x);
        put(own, f + 1, y);
        put(own, f + 2, z);
        put(own, f + 3, w);
    }
}

BEAD_WIDE_REGISTERS
void solve_one_forward(const DensePanel& panel, double* own, double* border) {
    const Index n = panel.own, m = panel.border;
    for (Index j = 0; j < n; ++j) {
        const double *const a = panel.values + j * (n + m), *const p = a + n;
        const double x = own[j] /= a[j];
        for (Index i = j + 1; i < n; ++i) own[i] -= a[i] * x;
        for (Index i = 0; i < m; ++i) border[i] -= p[i] * x;
    }
}

BEAD_WIDE_REGISTERS
void solve_one_backward(const DensePanel& panel, double* own, const double* border) {
    const Index n = panel.own, m = panel.border;
    for (Index j = n; j-- > 0;) {
        const double *const a = panel.values + j * (n + m), *const p = a + n;
        own[j] =
            (own[j] - dot_product(a + j + 1, own + j + 1, n - j - 1) - dot_product(p, border, m)) /
            a[j];
    }
}

}  // namespace bead
