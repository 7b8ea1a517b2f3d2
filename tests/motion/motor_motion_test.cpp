#include "motion/motor_motion.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/error.h"
#include "support/delta_twin.h"

namespace bead {
namespace {

using namespace test;

constexpr std::array linear{Kinematics::cartesian, Kinematics::corexy, Kinematics::corexz};

bool near(double a, double b, double scale = 1) { return std::abs(a - b) <= 1e-9 * scale; }

Block turned(Block block, double angle) {
    const Vec2 d = rotated({block.delta[axis_x], block.delta[axis_y]}, unit(angle));
    block.delta[axis_x] = d.x;
    block.delta[axis_y] = d.y;
    return block;
}

TEST(MotorMotion, OfAStartAndStopByHand) {
    const Block block = trapezoid({100, 0, 0, 4}, 0, 0, 80, 1000);
    const auto x = motor_motion(Kinematics::cartesian, block);
    EXPECT_NEAR(x[axis_x].gained, 3200, 1e-9);
    EXPECT_NEAR(x[axis_x].lost, 3200, 1e-9);
    EXPECT_NEAR(x[axis_x].coast, 93.6, 1e-9);
    EXPECT_EQ(x[axis_x].hold, 0);
    EXPECT_NEAR(x[axis_y].hold, 1.33, 1e-12);
    EXPECT_EQ(x[axis_e].way, 4);
    const auto core = motor_motion(Kinematics::corexy, block);
    EXPECT_EQ(core[0].displacement, 100);
    EXPECT_EQ(core[1].displacement, 100);
    EXPECT_NEAR(core[1].coast, 93.6, 1e-9);
}

TEST(MotorMotion, OfADiagonalLeavesOneMotorOfACoreStanding) {
    const Block xy = trapezoid({30, 30, 0, 0}, 0, 0, 80, 1000);
    const auto core = motor_motion(Kinematics::corexy, xy);
    EXPECT_EQ(core[0].displacement, 60);
    EXPECT_EQ(core[1].way, 0);
    EXPECT_EQ(core[1].hold, duration(xy));
    const auto xz = motor_motion(Kinematics::corexz, trapezoid({5, 1, -5, 0}, 0, 0, 80, 1000));
    EXPECT_EQ(xz[axis_x].way, 0);
    EXPECT_EQ(xz[axis_y].displacement, 1);
    EXPECT_EQ(xz[axis_z].displacement, 10);
}

RC_GTEST_PROP(MotorMotion, OfACoreTurnedByAnEighthIsCartesianWithScaledSpeeds, ()) {
    const Block block = any_block();
    const auto axes = motor_motion(Kinematics::cartesian, block);
    const auto core = motor_motion(Kinematics::corexy, turned(block, pi / 4));
    for (std::size_t i = 0; i < 2; ++i) {
        const MotorMotion &m = core[i], &a = axes[i];
        RC_ASSERT(near(m.way, std::sqrt(2) * a.way, 100));
        RC_ASSERT(near(m.coast, std::sqrt(2) * a.coast, 100));
        RC_ASSERT(near(m.gained, 2 * a.gained, 1e5) && near(m.lost, 2 * a.lost, 1e5));
    }
}

RC_GTEST_PROP(MotorMotion, GainsAndLosesWhatItsSpeedsSay, ()) {
    const PlacedBlock placed = any_placed_block();
    const Block& b = placed.block;
    const double h = 1e-4;  // mm
    const auto motions = motor_motion(a_delta, placed.from, b);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto rate = [&](double s) {
            return (carriage_height(a_delta, i, head_at(placed, s + h)) -
                    carriage_height(a_delta, i, head_at(placed, s - h))) /
                   (2 * h);
        };
        const double start = rate(0) * b.v_entry, end = rate(b.length) * b.v_exit;
        RC_ASSERT(std::abs(motions[i].gained - motions[i].lost - (end * end - start * start) / 2) <=
                  1e-5 * b.v_peak * b.v_peak);
    }
}

// Way of a carriage, and half of what the square of its speed gains, over a stretch of the head's
// way in which the square of the head's speed goes evenly from `v2` to `w2`.
struct Stepped {
    double way = 0, gained = 0;
};
Stepped by_steps(const PlacedBlock& placed, std::size_t tower, double from, double length,
                 double v2, double w2) {
    const int steps = 1500;
    const double step = length / steps, h = 1e-4;  // mm
    const auto height = [&](double s) {
        return carriage_height(a_delta, tower, head_at(placed, s));
    };
    Stepped sum;
    double before = 0;
    for (int k = 0; k <= steps; ++k) {
        const double s = from + k * step, rate = (height(s + h) - height(s - h)) / (2 * h);
        const double squared = rate * rate * (v2 + (w2 - v2) * k / steps);
        if (k < steps) sum.way += std::abs(height(s + step) - height(s));
        if (k > 0) sum.gained += std::max(0.0, squared - before) / 2;
        before = squared;
    }
    return sum;
}

RC_GTEST_PROP(MotorMotion, OfADeltaAgreesWithSmallSteps, ()) {
    const PlacedBlock placed = any_placed_block();
    const Block& b = placed.block;
    const double v0 = b.v_entry * b.v_entry, v = b.v_peak * b.v_peak, v1 = b.v_exit * b.v_exit;
    const double up = (v - v0) / 2 / b.acceleration, down = (v - v1) / 2 / b.acceleration;
    const auto motions = motor_motion(a_delta, placed.from, b);
    for (std::size_t i = 0; i < 3; ++i) {
        const Stepped first = by_steps(placed, i, 0, up, v0, v);
        const Stepped second = by_steps(placed, i, up, b.length - up - down, v, v);
        const Stepped third = by_steps(placed, i, b.length - down, down, v, v1);
        RC_ASSERT(near(motions[i].way, first.way + second.way + third.way, 1e5));
        RC_ASSERT(near(motions[i].coast, second.way, 1e5));
        RC_ASSERT(std::abs(motions[i].gained - first.gained - second.gained - third.gained) <=
                  1e-5 * v);
        const double rise = carriage_height(a_delta, i, head_at(placed, b.length)) -
                            carriage_height(a_delta, i, head_at(placed, 0));
        RC_ASSERT(near(motions[i].displacement, rise, 10));
    }
}

RC_GTEST_PROP(MotorMotion, OfTheWayBackIsThatOfTheWayThereInReverse, ()) {
    const PlacedBlock placed = any_placed_block();
    Block back = placed.block;
    for (double& d : back.delta) d = -d;
    std::swap(back.v_entry, back.v_exit);
    std::swap(back.t_accel, back.t_decel);
    const Vec2 end = placed.from + Vec2{placed.block.delta[axis_x], placed.block.delta[axis_y]};
    const auto there = motor_motion(a_delta, placed.from, placed.block);
    const auto home = motor_motion(a_delta, end, back);
    const double top = 1e4 * placed.block.v_peak * placed.block.v_peak;
    for (std::size_t i = 0; i < 4; ++i) {
        RC_ASSERT(near(there[i].displacement, -home[i].displacement, 100));
        RC_ASSERT(near(there[i].way, home[i].way, 100) && near(there[i].coast, home[i].coast, 100));
        RC_ASSERT(near(there[i].gained, home[i].lost, top));
    }
}

RC_GTEST_PROP(MotorMotion, OfADeltaTurnedByAThirdGoesToTheNextTower, ()) {
    const PlacedBlock placed = any_placed_block();
    const double third = 2 * pi / 3;
    const auto before = motor_motion(a_delta, placed.from, placed.block);
    const auto after =
        motor_motion(a_delta, rotated(placed.from, unit(third)), turned(placed.block, third));
    for (std::size_t i = 0; i < 3; ++i) {
        RC_ASSERT(near(before[i].displacement, after[(i + 1) % 3].displacement, 100));
        RC_ASSERT(near(before[i].way, after[(i + 1) % 3].way, 100));
    }
}

RC_GTEST_PROP(MotorMotion, AddsUpOverParts, ()) {
    const PlacedBlock placed = any_placed_block();
    const Block& whole = placed.block;
    RC_PRE(whole.t_cruise > 1e-6);
    Block first = whole, second = whole;
    first.t_decel = second.t_accel = 0;
    first.t_cruise = second.t_cruise = whole.t_cruise / 2;
    first.v_exit = second.v_entry = whole.v_peak;
    const double cut = way_after(whole, whole.t_accel + whole.t_cruise / 2) / whole.length;
    for (std::size_t i = 0; i < 4; ++i) {
        first.delta[i] *= cut;
        second.delta[i] *= 1 - cut;
    }
    first.length *= cut;
    second.length *= 1 - cut;
    const auto same = [&](const MotorMotion& w, const MotorMotion& a, const MotorMotion& b) {
        const double top = whole.v_peak * whole.v_peak;
        return near(w.displacement, a.displacement + b.displacement, 100) &&
               near(w.way, a.way + b.way, 100) && near(w.coast, a.coast + b.coast, 100) &&
               near(w.gained, a.gained + b.gained, top) && near(w.lost, a.lost + b.lost, top);
    };
    for (const Kinematics kind : linear) {
        const auto w = motor_motion(kind, whole), a = motor_motion(kind, first),
                   b = motor_motion(kind, second);
        for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(same(w[i], a[i], b[i]));
    }
    const Vec2 middle = placed.from + Vec2{first.delta[axis_x], first.delta[axis_y]};
    const auto w = motor_motion(a_delta, placed.from, whole),
               a = motor_motion(a_delta, placed.from, first),
               b = motor_motion(a_delta, middle, second);
    for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(same(w[i], a[i], b[i]));
}

TEST(MotorMotion, OfADeltaRisingInTheMiddleIsTheSameForEveryCarriage) {
    const Block up = trapezoid({0, 0, 50, 0}, 0, 0, 80, 1000);
    const auto rising = motor_motion(a_delta, {}, up);
    const MotorMotion z = motor_motion(Kinematics::cartesian, up)[axis_z];
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(rising[i].displacement, 50, 1e-9);
        EXPECT_NEAR(rising[i].coast, z.coast, 1e-9);
        EXPECT_NEAR(rising[i].gained, z.gained, 1e-6);
        EXPECT_NEAR(rising[i].lost, z.lost, 1e-6);
    }
}

TEST(MotorMotion, OfADeltaWithEndlessArmsIsNoneForLevelMoves) {
    const Block level = trapezoid({60, -30, 0, 0}, 0, 0, 80, 1000);
    double before = 1e300;
    for (const double arm : {1e3, 1e4, 1e5, 1e6}) {
        const auto motions = motor_motion(Delta{.arm = arm, .radius = 160}, {10, 20}, level);
        double way = 0;
        for (std::size_t i = 0; i < 3; ++i) way += motions[i].way;
        EXPECT_LT(way, 0.11 * before);
        before = way;
    }
    EXPECT_LT(before, 0.1);
}

TEST(MotorMotion, OfADeltaDependsOnThePlace) {
    const Block level = trapezoid({20, 0, 0, 0}, 0, 0, 80, 1000);
    EXPECT_GT(motor_motion(a_delta, {80, 0}, level)[0].way,
              1.5 * motor_motion(a_delta, {-20, 0}, level)[0].way);
}

TEST(MotorMotion, BeyondTheArmsIsAnErrorThatSaysWhere) {
    Block far = trapezoid({150, 0, 0, 0}, 0, 0, 80, 1000);
    far.line = 77;
    try {
        motor_motion(a_delta, {0, 0}, far);
        FAIL();
    } catch (const Error& e) {
        const std::string text = e.what();
        EXPECT_EQ(text.find("line 77: the head cannot be at X150 Y0"), 0U) << text;
        EXPECT_NE(text.find("check [delta]"), text.npos) << text;
    }
    EXPECT_NO_THROW(motor_motion(a_delta, {0, 0}, trapezoid({0, 0, 0, 5}, 0, 0, 30, 1000)));
}

}  // namespace
}  // namespace bead
