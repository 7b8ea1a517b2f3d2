#include "energy/motor_features.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/blocks.h"

namespace bead {
namespace {

using namespace test;

Features of(const Block& block, Kinematics kinematics) {
    return motor_features(block, kinematics, motor_motion(kinematics, block));
}

RC_GTEST_PROP(MotorFeatures, OfACartesianMachineAreThePublishedOnes, ()) {
    const Block block = any_block();
    const Features ours = of(block, Kinematics::cartesian), published = features_of(block);
    RC_ASSERT(std::abs(published_energy(ours) - published_energy(published)) <= 1e-9);
    RC_ASSERT(std::abs(ours.H - published.H) <= 1e-12);
    RC_ASSERT(ours.axis_time == published.axis_time);
}

TEST(MotorFeatures, OfACoreCoastWithBothMotorsAlongXAndWithOneOnADiagonal) {
    const Block along = trapezoid({100, 0, 0, 0}, 80, 80, 80, 1000);
    EXPECT_NEAR(of(along, Kinematics::corexy).C, 200, 1e-9);
    EXPECT_EQ(of(along, Kinematics::corexy).H, 0);
    const Block diagonal = trapezoid({100, 100, 0, 0}, 80, 80, 80, 1000);
    EXPECT_NEAR(of(diagonal, Kinematics::corexy).C, 200, 1e-9);
    EXPECT_EQ(of(diagonal, Kinematics::corexy).H, duration(diagonal));
    EXPECT_EQ(of(diagonal, Kinematics::corexy).A, features_of(diagonal).A);
}

}  // namespace
}  // namespace bead
