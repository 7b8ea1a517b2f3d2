#include "motion/trapezoid.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"

namespace bead {

Trapezoid trapezoid(double length, double v_nominal, double v_entry, double v_exit,
                    double acceleration) {
    BEAD_EXPECTS(length > 0 && v_nominal > 0 && acceleration > 0);
    const double room = 2 * acceleration * length;  // most by which v² can change
    const double v0 = std::clamp(v_entry, 0.0, v_nominal);
    const double lowest = std::sqrt(std::max(0.0, v0 * v0 - room));
    const double v1 = std::clamp(std::min(v_exit, v_nominal), lowest, std::sqrt(v0 * v0 + room));

    const double apex = std::sqrt((room + v0 * v0 + v1 * v1) / 2);
    const double peak = std::min(v_nominal, std::max({apex, v0, v1}));
    Trapezoid t{v0, peak, v1, (peak - v0) / acceleration, 0, (peak - v1) / acceleration};
    if (apex > v_nominal) {
        const double ramps = (2 * peak * peak - v0 * v0 - v1 * v1) / (2 * acceleration);
        t.t_cruise = (length - ramps) / peak;
    }
    return t;
}

}  // namespace bead
