// Symmetric tensors in space and their principal values.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "geom/vec.h"

namespace bead {

struct Tensor3 {
    double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
};

constexpr Tensor3 operator+(const Tensor3& a, const Tensor3& b) {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
}
constexpr Tensor3 operator*(double s, const Tensor3& a) {
    return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
}

inline double von_mises(const Tensor3& t) {
    const double a = t.xx - t.yy, b = t.yy - t.zz, c = t.zz - t.xx;
    return std::sqrt((a * a + b * b + c * c) / 2 + 3 * (t.xy * t.xy + t.yz * t.yz + t.zx * t.zx));
}

// Largest first, by the cosine of a third of an angle (Smith 1961).
inline std::array<double, 3> principal_values(const Tensor3& t) {
    const double mean = (t.xx + t.yy + t.zz) / 3;
    const double spread = von_mises(t) * std::sqrt(2.0) / 3;  // sqrt(tr(dev²)/3)
    if (spread < 1e-300) return {mean, mean, mean};
    const double p = spread / std::sqrt(2.0);
    const double a = (t.xx - mean) / p, b = (t.yy - mean) / p, c = (t.zz - mean) / p;
    const double d = t.xy / p, e = t.yz / p, f = t.zx / p;
    const double half = (a * (b * c - e * e) - d * (d * c - e * f) + f * (d * e - b * f)) / 2;
    const double angle = std::acos(std::clamp(half, -1.0, 1.0)) / 3;
    const double first = mean + 2 * p * std::cos(angle);
    const double last = mean + 2 * p * std::cos(angle + 2 * pi / 3);
    return {first, 3 * mean - first - last, last};
}

}  // namespace bead
