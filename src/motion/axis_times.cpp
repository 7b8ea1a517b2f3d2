#include "motion/axis_times.h"

#include <cmath>

namespace bead {

void add(PerAxis<AxisTimes>& times, const Block& block) {
    for (std::size_t i = 0; i < times.size(); ++i) {
        AxisTimes& axis = times[i];
        axis.distance += std::abs(block.delta[i]);
        if (block.delta[i] == 0) {
            axis.hold += duration(block);
        } else {
            axis.accelerate += block.t_accel;
            axis.coast += block.t_cruise;
            axis.decelerate += block.t_decel;
        }
    }
}

void add(PerAxis<AxisTimes>& times, const Dwell& dwell) {
    for (AxisTimes& axis : times) axis.hold += dwell.duration;
}

}  // namespace bead
