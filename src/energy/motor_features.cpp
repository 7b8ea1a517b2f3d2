#include "energy/motor_features.h"

#include "energy/motors.h"

namespace bead {

Features motor_features(const Block& block, Kinematics kinematics,
                        const PerAxis<MotorMotion>& motions) {
    const Features axes = features_of(block);
    Features features{.A = axes.A, .B = axes.B};
    for (std::size_t slot = 0; slot < motions.size(); ++slot) {
        if (!turns_in_xy(kinematics, slot)) continue;
        features.C += motions[slot].coast;
        features.H += motions[slot].hold;
        features.axis_time += duration(block);
    }
    return features;
}

}  // namespace bead
