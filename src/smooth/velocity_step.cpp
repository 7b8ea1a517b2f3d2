#include "smooth/velocity_step.h"

#include <cmath>
#include <numbers>

#include "toolpath/command.h"

namespace bead {

VelocityStep velocity_step(Firmware firmware, const Limits& limits) {
    const auto by_deviation = [](double acceleration_deviation) {
        return VelocityStep{.any = std::sqrt(8 * acceleration_deviation)};
    };
    switch (firmware) {
        case Firmware::prusa:
        case Firmware::prusa_2017:
        case Firmware::marlin_jerk:
            return {.x = limits.jerk[axis_x], .y = limits.jerk[axis_y]};
        case Firmware::marlin_jd:
            return by_deviation(limits.acceleration * limits.junction_deviation);
        case Firmware::klipper:
        case Firmware::s_curve:
            return by_deviation(limits.square_corner_velocity * limits.square_corner_velocity *
                                (std::numbers::sqrt2 - 1));
    }
    return {};
}

}  // namespace bead
