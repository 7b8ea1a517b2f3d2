#include "fem/grid_operator.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

// What a row of elements gives to the nodes at its corners: buffers of one more than the row's
// length, the first place of each being 0, so that node i gets left[i + 1] + right[i].
template <class Real>
struct RowBuffers {
    explicit RowBuffers(std::size_t count, int cells)
        : stride(std::size_t(cells) + 2), values(count * stride, Real(0)) {}
    Real* at(std::size_t k) { return values.data() + k * stride + 1; }
    std::size_t stride;
    std::vector<Real> values;
};

template <class Real>
struct RowInput {
    const float* factor;
    int begin, end;  // cells of the row that are there
};

struct Run {
    int begin = 0, end = 0;
};

Run present(const float* factor, int cells) {
    Run run{0, cells};
    while (run.begin < run.end && factor[run.begin] == 0) ++run.begin;
    while (run.end > run.begin && factor[run.end - 1] == 0) --run.end;
    return run;
}

// Node i of the run gets what the element to its right gives its left corner and the element to its
// left its right corner.
template <class Real>
void hand_out(Run run, const Real* left, const Real* right, Real* __restrict to) {
    to[run.begin] += left[run.begin];
    for (int i = run.begin + 1; i < run.end; ++i) to[i] += left[i] + right[i - 1];
    to[run.end] += right[run.end - 1];
}

template <class Real>
struct PlaneConstants {
    Real xx, xy, yy, xs, ys, ss;
};

template <class Real>
void plane_row(Run run, const PlaneConstants<Real>& d, const float* __restrict factor,
               const std::array<const Real*, 4>& u, const std::array<Real*, 8>& f) {
    const Real* __restrict x0 = u[0];  // lower nodes, x
    const Real* __restrict x1 = u[1];  // upper
    const Real* __restrict y0 = u[2];
    const Real* __restrict y1 = u[3];
    Real* __restrict f0 = f[0], * __restrict f1 = f[1], * __restrict f2 = f[2], * __restrict f3 = f[3], * __restrict f4 = f[4], * __restrict f5 = f[5], * __restrict f6 = f[6], * __restrict f7 = f[7];
    constexpr Real third = Real(1.0 / 3), quarter = Real(0.25);
    for (int i = run.begin; i < run.end; ++i) {
        const Real k = quarter * Real(factor[i]);
        const Real xl = x0[i + 1] - x0[i], xu = x1[i + 1] - x1[i];
        const Real yl = y0[i + 1] - y0[i], yu = y1[i + 1] - y1[i];
        const Real exx = k * (xl + xu), xxy = k * (xu - xl), yxy = k * (yu - yl);
        const Real eyy = k * (y1[i] + y1[i + 1] - y0[i] - y0[i + 1]);
        const Real gxy = k * (x1[i] + x1[i + 1] - x0[i] - x0[i + 1] + yl + yu);
        const Real sxx = d.xx * exx + d.xy * eyy + d.xs * gxy;
        const Real syy = d.xy * exx + d.yy * eyy + d.ys * gxy;
        const Real sxy = d.xs * exx + d.ys * eyy + d.ss * gxy;
        // Along y the strain is (xxy, 0, yxy), along x (0, yxy, xxy).
        const Real hx = third * (d.xx * xxy + d.xs * yxy + d.ys * yxy + d.ss * xxy);
        const Real hy = third * (d.yy * yxy + d.ys * xxy + d.xs * xxy + d.ss * yxy);
        f0[i] = hx - sxx - sxy;
        f1[i] = sxx - sxy - hx;
        f2[i] = sxy - sxx - hx;
        f3[i] = sxx + sxy + hx;
        f4[i] = hy - sxy - syy;
        f5[i] = sxy - syy - hy;
        f6[i] = syy - sxy - hy;
        f7[i] = sxy + syy + hy;
    }
}

template <class Real>
void multiply_plane(const ElasticGrid& grid, const Real* u, Real* result) {
    const int nx = grid.cells[0] + 1;
    const std::size_t nodes = grid.nodes();
    const PlaneLaw& l = grid.law;
    const PlaneConstants<Real> d{Real(l.xx), Real(l.xy), Real(l.yy),
                                 Real(l.xs), Real(l.ys), Real(l.ss)};
    RowBuffers<Real> buffers(8, grid.cells[0]);
    std::array<Real*, 8> f{};
    for (std::size_t k = 0; k < 8; ++k) f[k] = buffers.at(k);
    std::fill(result, result + 2 * nodes, Real(0));
    for (int j = 0; j < grid.cells[1]; ++j) {
        const float* factor = grid.factor.data() + std::ptrdiff_t(j) * grid.cells[0];
        const Run run = present(factor, grid.cells[0]);
        if (run.begin == run.end) continue;
        const std::size_t low = std::size_t(j) * std::size_t(nx), high = low + std::size_t(nx);
        plane_row<Real>(run, d, factor, {u + low, u + high, u + nodes + low, u + nodes + high}, f);
        hand_out(run, f[0], f[1], result + low);
        hand_out(run, f[2], f[3], result + high);
        hand_out(run, f[4], f[5], result + nodes + low);
        hand_out(run, f[6], f[7], result + nodes + high);
    }
}

// Eight corner values of one component as sums over the signs of (x, y, z): constant and products.
// Names tell the signs: `yz` is the part that goes like y z.
template <class Real>
struct CubeModes {
    Real x, y, z, yz, xz, xy, xyz;
};

template <class Real>
inline CubeModes<Real> cube_modes(const Real* a, const Real* b, const Real* c, const Real* e,
                                  int i) {
    // a: lower y, lower z; b: upper y, lower z; c: lower y, upper z; e: both upper.
    const Real ap = a[i] + a[i + 1], am = a[i + 1] - a[i];
    const Real bp = b[i] + b[i + 1], bm = b[i + 1] - b[i];
    const Real cp = c[i] + c[i + 1], cm = c[i + 1] - c[i];
    const Real ep = e[i] + e[i + 1], em = e[i + 1] - e[i];
    const Real lp = ap + bp, lq = bp - ap, up = cp + ep, uq = ep - cp;
    const Real lm = am + bm, ln = bm - am, um = cm + em, un = em - cm;
    return {lm + um, lq + uq, up - lp, uq - lq, um - lm, ln + un, un - ln};
}

// And back: what the modes' forces are at the corners.
template <class Real>
inline void cube_corners(const CubeModes<Real>& g, Real* const* f, int i) {
    const Real lz = -g.z, uz = g.z;
    const Real lx = g.x - g.xz, ux = g.x + g.xz;
    const Real ly = g.y - g.yz, uy = g.y + g.yz;
    const Real lxy = g.xy - g.xyz, uxy = g.xy + g.xyz;
    f[0][i] = lz - ly - lx + lxy;
    f[1][i] = lz - ly + lx - lxy;
    f[2][i] = lz + ly - lx - lxy;
    f[3][i] = lz + ly + lx + lxy;
    f[4][i] = uz - uy - ux + uxy;
    f[5][i] = uz - uy + ux - uxy;
    f[6][i] = uz + uy - ux - uxy;
    f[7][i] = uz + uy + ux + uxy;
}

template <class Real>
struct CubeConstants {
    Real lambda, two_mu, mu;
};

template <class Real>
inline void cube(const CubeConstants<Real>& d, Real factor, const Real* const* u, Real* const* f,
                 int i) {
    const CubeModes<Real> a = cube_modes(u[0], u[1], u[2], u[3], i);
    const CubeModes<Real> b = cube_modes(u[4], u[5], u[6], u[7], i);
    const CubeModes<Real> c = cube_modes(u[8], u[9], u[10], u[11], i);
    constexpr Real third = Real(1.0 / 3), ninth = Real(1.0 / 9);
    const Real k = factor, k3 = third * factor, k9 = ninth * factor;
    const Real m = d.mu * k, m3 = d.mu * k3, m9 = d.mu * k9;
    const Real n = d.two_mu * k, n3 = d.two_mu * k3, n9 = (d.two_mu + d.lambda) * k9;
    const Real trace = d.lambda * k * (a.x + b.y + c.z);
    const Real sxy = m * (a.y + b.x), syz = m * (b.z + c.y), szx = m * (c.x + a.z);
    // What goes like y, like x, like z.
    const Real l3 = d.lambda * k3;
    const Real ty = l3 * (a.xy + c.yz), tx = l3 * (b.xy + c.xz), tz = l3 * (a.xz + b.yz);
    const Real y_zx = m3 * (a.yz + c.xy), x_yz = m3 * (b.xz + c.xy), z_xy = m3 * (a.yz + b.xz);
    const CubeModes<Real> ga{trace + n * a.x,
                             sxy,
                             szx,
                             y_zx + z_xy,
                             tz + n3 * a.xz + m3 * a.xz,
                             ty + n3 * a.xy + m3 * a.xy,
                             n9 * a.xyz + m9 * (a.xyz + a.xyz)};
    const CubeModes<Real> gb{sxy,
                             trace + n * b.y,
                             syz,
                             tz + n3 * b.yz + m3 * b.yz,
                             x_yz + z_xy,
                             tx + n3 * b.xy + m3 * b.xy,
                             n9 * b.xyz + m9 * (b.xyz + b.xyz)};
    const CubeModes<Real> gc{szx,
                             syz,
                             trace + n * c.z,
                             ty + n3 * c.yz + m3 * c.yz,
                             tx + n3 * c.xz + m3 * c.xz,
                             x_yz + y_zx,
                             n9 * c.xyz + m9 * (c.xyz + c.xyz)};
    cube_corners(ga, f, i);
    cube_corners(gb, f + 8, i);
    cube_corners(gc, f + 16, i);
}

template <class Real>
void multiply_space(const ElasticGrid& grid, const Real* u, Real* result) {
    const std::size_t nx = std::size_t(grid.cells[0]) + 1, ny = std::size_t(grid.cells[1]) + 1;
    const std::size_t nodes = grid.nodes();
    const CubeConstants<Real> d{Real(grid.lambda / 16), Real(grid.mu / 8), Real(grid.mu / 16)};
    RowBuffers<Real> buffers(24, grid.cells[0]);
    std::array<Real*, 24> f{};
    for (std::size_t k = 0; k < 24; ++k) f[k] = buffers.at(k);
    std::fill(result, result + 3 * nodes, Real(0));
    for (int z = 0; z < grid.cells[2]; ++z)
        for (int y = 0; y < grid.cells[1]; ++y) {
            const float* factor =
                grid.factor.data() + (std::ptrdiff_t(z) * grid.cells[1] + y) * grid.cells[0];
            const Run run = present(factor, grid.cells[0]);
            if (run.begin == run.end) continue;
            std::array<std::size_t, 4> line{};
            line[0] = (std::size_t(z) * ny + std::size_t(y)) * nx;
            line[1] = line[0] + nx;
            line[2] = line[0] + nx * ny;
            line[3] = line[2] + nx;
            std::array<const Real*, 12> in{};
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t k = 0; k < 4; ++k) in[4 * c + k] = u + c * nodes + line[k];
#ifndef __clang__
#pragma GCC ivdep
#endif
            for (int i = run.begin; i < run.end; ++i)
                cube<Real>(d, Real(factor[i]), in.data(), f.data(), i);
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t k = 0; k < 4; ++k)
                    hand_out(run, f[8 * c + 2 * k], f[8 * c + 2 * k + 1],
                             result + c * nodes + line[k]);
        }
}

template <class Real>
void multiply_any(const ElasticGrid& grid, const Real* u, Real* result) {
    if (grid.dimensions == 2)
        multiply_plane(grid, u, result);
    else
        multiply_space(grid, u, result);
}

// A unit value of each corner's component in turn.
ElasticGrid one_element(const ElasticGrid& grid) {
    ElasticGrid one{grid.dimensions, {1, 1, grid.dimensions == 3 ? 1 : 0},
                    {1.0F},          grid.law,
                    grid.lambda,     grid.mu};
    return one;
}

std::vector<double> element_diagonal(const ElasticGrid& one) {
    const std::size_t count = one.unknowns();
    std::vector<double> unit_value(count), column(count), result(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::ranges::fill(unit_value, 0.0);
        unit_value[i] = 1;
        multiply(one, unit_value.data(), column.data());
        result[i] = column[i];
    }
    return result;
}

}  // namespace

void multiply(const ElasticGrid& grid, const float* u, float* result) {
    multiply_any(grid, u, result);
}

void multiply(const ElasticGrid& grid, const double* u, double* result) {
    multiply_any(grid, u, result);
}

std::vector<float> diagonal(const ElasticGrid& grid) {
    const ElasticGrid one = one_element(grid);
    const std::vector<double> corner = element_diagonal(one);
    const std::size_t nodes = grid.nodes();
    std::vector<float> sums(grid.unknowns(), 0.0F);
    const std::size_t nx = std::size_t(grid.cells[0]) + 1, ny = std::size_t(grid.cells[1]) + 1;
    const int depth = std::max(1, grid.cells[2]);
    std::size_t cell = 0;
    for (std::size_t z = 0; z < std::size_t(depth); ++z)
        for (std::size_t y = 0; y + 1 < ny; ++y)
            for (std::size_t x = 0; x + 1 < nx; ++x, ++cell) {
                if (grid.factor[cell] == 0) continue;
                for (std::size_t k = 0; k < one.nodes(); ++k) {
                    const std::size_t node = ((z + k / 4) * ny + y + k / 2 % 2) * nx + x + k % 2;
                    for (std::size_t c = 0; c < std::size_t(grid.dimensions); ++c)
                        sums[c * nodes + node] +=
                            grid.factor[cell] * float(corner[c * one.nodes() + k]);
                }
            }
    return sums;
}

double largest_eigenvalue(const ElasticGrid& grid) {
    const ElasticGrid one = one_element(grid);
    const std::vector<double> d = element_diagonal(one);
    std::vector<double> v(d.size()), w(d.size());
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = 1 + 0.37 * double(i * i % 11) - double(i % 3);
    double value = 0;
    for (int step = 0; step < 200; ++step) {
        multiply(one, v.data(), w.data());
        value = 0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            w[i] /= d[i];
            value = std::max(value, std::abs(w[i]));
        }
        for (std::size_t i = 0; i < v.size(); ++i) v[i] = w[i] / value;
    }
    return value;
}

}  // namespace bead
