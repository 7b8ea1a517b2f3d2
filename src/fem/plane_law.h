// How stress follows strain in the plane: a symmetric 3 x 3 matrix (MPa) from engineering strains
// (exx, eyy, gxy) to stresses (sxx, syy, sxy). Isotropic for a solid; any for homogenised infill.
#pragma once
#include "field/tensor.h"

namespace bead {

struct PlaneLaw {
    double xx = 0, xy = 0, yy = 0;  // normal stresses from normal strains
    double xs = 0, ys = 0, ss = 0;  // with shear
    bool operator==(const PlaneLaw&) const = default;
};

constexpr PlaneLaw operator+(const PlaneLaw& a, const PlaneLaw& b) {
    return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy, a.xs + b.xs, a.ys + b.ys, a.ss + b.ss};
}
constexpr PlaneLaw operator*(double s, const PlaneLaw& a) {
    return {s * a.xx, s * a.xy, s * a.yy, s * a.xs, s * a.ys, s * a.ss};
}

// Plane stress: D = E/(1 - nu²) [[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu)/2]].
constexpr PlaneLaw isotropic(double young, double poisson) {
    const double d = young / (1 - poisson * poisson);
    return {d, d * poisson, d, 0, 0, d * (1 - poisson) / 2};
}

// Bars along `direction` (a unit vector) with stiffness `young` times their share of the volume:
// young m m^T with m = (c², s², cs).
constexpr PlaneLaw bars(double young, Vec2 direction) {
    const double m[3] = {direction.x * direction.x, direction.y * direction.y,
                         direction.x * direction.y};
    return {young * m[0] * m[0], young * m[0] * m[1], young * m[1] * m[1],
            young * m[0] * m[2], young * m[1] * m[2], young * m[2] * m[2]};
}

// `strain.xy` is the engineering shear, twice the tensor's component.
constexpr PlaneTensor stress_of(const PlaneLaw& d, PlaneTensor strain) {
    return {d.xx * strain.xx + d.xy * strain.yy + d.xs * strain.xy,
            d.xy * strain.xx + d.yy * strain.yy + d.ys * strain.xy,
            d.xs * strain.xx + d.ys * strain.yy + d.ss * strain.xy};
}

}  // namespace bead
