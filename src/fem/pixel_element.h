// The square Q4 element by its modes. Its corner displacements are sums of a constant, a part
// linear in each direction and a part x*y; in these the exact integrals of the strain energy fall
// apart into three small products with the law, so that K u costs some fifty operations instead of
// 128, for any law. The size of the square cancels.
#pragma once
#include <array>
#include <span>

#include "fem/plane_law.h"

namespace bead {

// Eight numbers: x and y of the corners, counter-clockwise from the lower left.
using CornerValues = std::array<double, 8>;

// Displacement gradients times half the side: at the centre, and how they change along x and y.
struct SquareModes {
    PlaneTensor centre;  // exx, eyy, gxy
    double ux_xy = 0, uy_xy = 0;
};

constexpr SquareModes modes_of(const CornerValues& u) {
    const double x_x = (-u[0] + u[2] + u[4] - u[6]) / 4, x_y = (-u[0] - u[2] + u[4] + u[6]) / 4;
    const double y_x = (-u[1] + u[3] + u[5] - u[7]) / 4, y_y = (-u[1] - u[3] + u[5] + u[7]) / 4;
    return {
        {x_x, y_y, x_y + y_x}, (u[0] - u[2] + u[4] - u[6]) / 4, (u[1] - u[3] + u[5] - u[7]) / 4};
}

// Strain times half the side at (x, y) in [-1, 1]².
constexpr PlaneTensor strain_at(const SquareModes& m, double x, double y) {
    return {m.centre.xx + m.ux_xy * y, m.centre.yy + m.uy_xy * x,
            m.centre.xy + m.ux_xy * x + m.uy_xy * y};
}

// K u for unit thickness.
constexpr CornerValues square_forces(const PlaneLaw& law, const CornerValues& u) {
    const SquareModes m = modes_of(u);
    const PlaneTensor s = stress_of(law, m.centre);
    const PlaneTensor along_y = stress_of(law, {m.ux_xy, 0, m.uy_xy});
    const PlaneTensor along_x = stress_of(law, {0, m.uy_xy, m.ux_xy});
    const double x_xy = (along_y.xx + along_x.xy) / 3, y_xy = (along_x.yy + along_y.xy) / 3;
    return {-s.xx - s.xy + x_xy, -s.xy - s.yy + y_xy, s.xx - s.xy - x_xy,  s.xy - s.yy - y_xy,
            s.xx + s.xy + x_xy,  s.xy + s.yy + y_xy,  -s.xx + s.xy - x_xy, -s.xy + s.yy - y_xy};
}

// The element's stiffness, row by row, for unit thickness.
constexpr std::array<double, 64> square_stiffness(const PlaneLaw& law) {
    std::array<double, 64> matrix{};
    for (std::size_t j = 0; j < 8; ++j) {
        CornerValues unit_value{};
        unit_value[j] = 1;
        const CornerValues column = square_forces(law, unit_value);
        for (std::size_t i = 0; i < 8; ++i) matrix[8 * i + j] = column[i];
    }
    return matrix;
}

inline CornerValues corner_values(std::span<const double> all,
                                  const std::array<std::size_t, 4>& corners) {
    CornerValues u{};
    for (std::size_t c = 0; c < 4; ++c) {
        u[2 * c] = all[2 * corners[c]];
        u[2 * c + 1] = all[2 * corners[c] + 1];
    }
    return u;
}

}  // namespace bead
