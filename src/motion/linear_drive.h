// Motors that follow the axes by sums and differences: cartesian, CoreXY and CoreXZ. The matrix J
// from axes to motors is constant, so it maps places, ways, speeds and accelerations alike, and a
// block's times are those of every motor. Forces go the other way, by the transposed inverse: what
// motors give, force times speed, is then what the axes take.
#pragma once
#include "machine/kinematics.h"
#include "toolpath/command.h"

namespace bead {

// The axis that shares two motors with X.
template <Kinematics kind>
inline constexpr Axis partner_of_x = kind == Kinematics::corexz ? axis_z : axis_y;

template <Kinematics kind>
inline constexpr bool is_core = kind == Kinematics::corexy || kind == Kinematics::corexz;

// J q: A = X + Y, B = X - Y.
template <Kinematics kind>
constexpr PerAxis<double> motors_of(PerAxis<double> q) {
    if constexpr (is_core<kind>) {
        constexpr Axis other = partner_of_x<kind>;
        const double x = q[axis_x], y = q[other];
        q[axis_x] = x + y;
        q[other] = x - y;
    }
    return q;
}

// J⁻ᵀ F: what each motor has to pull with, so that F acts on the axes.
template <Kinematics kind>
constexpr PerAxis<double> pulls_of(PerAxis<double> force) {
    PerAxis<double> pull = motors_of<kind>(force);
    if constexpr (is_core<kind>) {
        pull[axis_x] /= 2;
        pull[partner_of_x<kind>] /= 2;
    }
    return pull;
}

}  // namespace bead
