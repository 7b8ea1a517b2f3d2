// The features of the published model (energy/published.h) where motors are not those of X and Y.
// A and B stay with the axes: they stand for moving energy, and that is the head's whoever moves
// it. C, H and the time are those of the motors which moves in X and Y turn: the coasting way that
// each goes, and the time in which each stands. On a cartesian machine these are the published
// features.
#pragma once
#include "energy/published.h"
#include "motion/motor_motion.h"

namespace bead {

// `motions` as motor_motion gives them for the block. The coefficients were fitted on a cartesian
// machine: to take them for another one is an estimate, not a publication.
Features motor_features(const Block& block, Kinematics kinematics,
                        const PerAxis<MotorMotion>& motions);

}  // namespace bead
