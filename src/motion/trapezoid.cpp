#include "motion/trapezoid.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"

namespace bead {

Trapezoid trapezoid(double length, double v_nominal, double v_entry, double v_exit,
                    double acceleration) {
    const double v0 = std::max(0.0, v_entry), v1 = std::max(0.0, v_exit);
    return trapezoid_of_squares(length, v_nominal, v0 * v0, v1 * v1, acceleration);
}

Trapezoid trapezoid_of_squares(double length, double v_nominal, double entry2, double exit2,
                               double acceleration) {
    BEAD_EXPECTS(length > 0 && v_nominal > 0 && acceleration > 0);
    const double room = 2 * acceleration * length;  // most by which v² can change
    const double most = v_nominal * v_nominal;
    const double in = std::min(entry2, most);
    const double out = std::clamp(std::min(exit2, most), std::max(0.0, in - room), in + room);

    const double per = 1 / acceleration;
    Trapezoid t;
    t.v_entry = in < most ? std::sqrt(in) : v_nominal;
    t.v_exit = out < most ? std::sqrt(out) : v_nominal;
    const double apex = (room + in + out) / 2;  // squared
    if (apex > most) {
        t.v_peak = v_nominal;
        t.t_cruise = (length - (most - (in + out) / 2) * per) / v_nominal;
    } else {
        t.v_peak = std::max({std::sqrt(apex), t.v_entry, t.v_exit});
    }
    t.t_accel = (t.v_peak - t.v_entry) * per;
    t.t_decel = (t.v_peak - t.v_exit) * per;
    return t;
}

}  // namespace bead
