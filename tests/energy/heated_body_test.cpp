#include "energy/heated_body.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/blocks.h"
#include "support/power_twin.h"

namespace bead {
namespace {

using namespace test;

TEST(HeatedBody, WithoutLossesTakesCapacityTimesRise) {
    HeatedBody body(40, 10, 25);
    body.aim(225);
    const double leak = 1e-9, time = body.warm_up_time(leak);
    EXPECT_NEAR(time, 50, 1e-4);
    EXPECT_NEAR(body.advance(time, leak).energy, 2000, 1e-2);
    EXPECT_EQ(body.temperature(), 225);
}

TEST(HeatedBody, ClimbsAsAnExponential) {
    HeatedBody body(40, 10, 25);
    body.aim(225);
    const double G = 0.05;  // rests at 825 °C, time constant 200 s
    EXPECT_NEAR(body.warm_up_time(G), 200 * std::log(800.0 / 600.0), 1e-9);
    body.advance(30, G);
    EXPECT_NEAR(body.temperature(), 825 - 800 * std::exp(-0.15), 1e-9);
}

TEST(HeatedBody, HoldsWithWhatItLoses) {
    HeatedBody body(40, 10, 25);
    body.aim(225);
    body.advance(1000, 0.05);
    const HeatDraw draw = body.advance(10, 0.05, 1.5);
    EXPECT_NEAR(draw.peak, 0.05 * 200 + 1.5, 1e-12);
    EXPECT_NEAR(draw.energy, 10 * draw.peak, 1e-12);
}

TEST(HeatedBody, CostsNothingWhenOffAndCoolsDown) {
    HeatedBody body(40, 10, 25);
    body.aim(225);
    body.advance(1000, 0.05);
    body.aim(0);
    EXPECT_EQ(body.advance(200, 0.05, 3).energy, 0);
    EXPECT_NEAR(body.temperature(), 25 + 200 * std::exp(-1.0), 1e-9);
}

TEST(HeatedBody, ThatIsTooWeakWaitsFiveTimeConstants) {
    HeatedBody body(40, 100, 25);
    body.aim(400);
    const double time = body.warm_up_time(0.2);  // rests at 225 °C
    EXPECT_NEAR(time, 5 * 100 / 0.2, 1e-9);
    EXPECT_NEAR(body.advance(time, 0.2).energy, 40 * time, 1e-6);
    EXPECT_NEAR(body.temperature(), 225, 0.01 * 200);
}

TEST(HeatedBody, OfNoPowerIsNotModelled) {
    HeatedBody body(0, 0, 25);
    body.aim(200);
    EXPECT_EQ(body.warm_up_time(0), 0);
    EXPECT_EQ(body.advance(10, 0).energy, 0);
}

// Any schedule of targets, fans and flows, strong enough or not, against steps of 2 ms.
RC_GTEST_PROP(HeatedBody, AgreesWithSmallSteps, ()) {
    HeatedBody body(30, 5, 20);
    SteppedBody twin{30, 5, 20, 20, 20};
    double energy = 0, expected = 0;
    for (int i = 0; i < 5; ++i) {
        const double target = number_between(0, 250), G = number_between(0.05, 0.2);
        const double load = number_between(0, 4), seconds = number_between(1, 60);
        body.aim(target);
        twin.target = std::max(target, 20.0);
        energy += body.advance(seconds, G, load).energy;
        const int steps = static_cast<int>(seconds / 2e-3);
        for (int k = 0; k < steps; ++k) expected += twin.step(seconds / steps, G, load);
        RC_ASSERT(std::abs(body.temperature() - twin.temperature) < 0.05);
    }
    RC_ASSERT(std::abs(energy - expected) < 1e-3 * expected + 0.2);
}

RC_GTEST_PROP(HeatedBody, DoesNotCareHowTimeIsCut, ()) {
    HeatedBody once(30, 5, 20), twice(30, 5, 20);
    const double G = number_between(0.05, 0.2), seconds = number_between(0, 200);
    const double load = number_between(0, 4), cut = number_between(0, seconds);
    once.aim(180);
    twice.aim(180);
    const double whole = once.advance(seconds, G, load).energy;
    const double parts =
        twice.advance(cut, G, load).energy + twice.advance(seconds - cut, G, load).energy;
    RC_ASSERT(std::abs(whole - parts) < 1e-6 * (1 + whole));
}

}  // namespace
}  // namespace bead
