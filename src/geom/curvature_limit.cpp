#include "geom/curvature_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/expects.h"

namespace bead {

CurvatureBounds curvature_bounds(const CurvatureLimits& limits, double speed) {
    BEAD_EXPECTS(speed > 0);
    const double step = speed * limits.period, error = limits.chord_error;
    return {8 * error / (step * step + 4 * error * error),
            limits.normal_acceleration / (speed * speed),
            std::sqrt(limits.normal_jerk / (speed * speed * speed)), 1 / limits.nozzle_radius};
}

double largest_curvature(const CurvatureLimits& limits, double speed) {
    const CurvatureBounds bounds = curvature_bounds(limits, speed);
    return std::min({bounds.chord, bounds.acceleration, bounds.jerk, bounds.nozzle});
}

double feed_limit(const CurvatureLimits& limits, double curvature, double curvature_change) {
    const double bend = std::abs(curvature), change = std::abs(curvature_change);
    double feed = std::numeric_limits<double>::infinity();
    if (bend > 0) {
        const double error = limits.chord_error, square = 2 * error / bend - error * error;
        // A circle of less than the error across has no chord that errs by more.
        if (square > 0 && limits.period > 0)
            feed = std::min(feed, 2 / limits.period * std::sqrt(square));
        feed = std::min({feed, std::sqrt(limits.normal_acceleration / bend),
                         std::cbrt(limits.normal_jerk / (bend * bend))});
    }
    return change > 0 ? std::min(feed, std::cbrt(limits.normal_jerk / change)) : feed;
}

}  // namespace bead
