#include "smooth/chords.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "smooth/round_corners.h"
#include "support/blocks.h"
#include "support/smooth_layers.h"

using namespace bead;
using namespace bead::test;

namespace {

Ribbon ribbon_of(Polyline line, Role role) {
    std::vector<Flow> flows(line.size() - 1, Flow{0.08, 50, role, 0});
    return {std::move(line), std::move(flows)};
}

Polyline any_line() {
    Polyline line{{0, 0}};
    const int count = *rc::gen::inRange(2, 12);
    for (int i = 0; i < count; ++i)
        line.push_back(line.back() + number_between(0.3, 20) * unit(number_between(-3.1, 3.1)));
    return line;
}

}  // namespace

RC_GTEST_PROP(RoundCorners, StayWithinTheirTolerance, ()) {
    const Ribbon before = ribbon_of(any_line(), Role::outer_wall);
    const RoundedRibbon after = rounded(before, {});
    RC_ASSERT(deviation(after.ribbon.points, before.points, 0.02) < 0.0501);
    RC_ASSERT(deviation(before.points, after.ribbon.points, 0.02) < 0.0501);
    RC_ASSERT(length(after.ribbon) <= length(before) + 1e-9);
    RC_ASSERT(after.ribbon.points.front() == before.points.front());
    RC_ASSERT(after.ribbon.points.back() == before.points.back());
    RC_ASSERT(after.ribbon.flows.size() + 1 == after.ribbon.points.size());
}

RC_GTEST_PROP(Chords, StayNearTheLine, ()) {
    const Ribbon before = rounded(ribbon_of(any_line(), Role::wall), {}).ribbon;
    const Ribbon after = chorded(measured(before), {});
    RC_ASSERT(deviation(after.points, before.points, 0.02) < 0.051);
    RC_ASSERT(after.points.size() <= before.points.size());
    RC_ASSERT(after.points.back() == before.points.back());
}

// Round bends at any speed: firmware that lets each axis step by so much does not brake in them.
RC_GTEST_PROP(Chords, StepByNoMoreThanTheFirmwareAllows, ()) {
    const double radius = number_between(1, 20), jerk = number_between(4, 12);
    Polyline loop = round_loop({}, radius, 4000);
    loop.push_back(loop.front());
    ChordOptions options;
    options.step = VelocityStep{.x = jerk, .y = 1.5 * jerk};
    options.acceleration = 1e6;  // the bend itself does not slow
    const Polyline chords = chorded(measured(ribbon_of(loop, Role::wall)), options).points;
    // Ends stay where they are and the last chord is as long as it comes out: not their neighbours.
    for (std::size_t i = 2; i + 3 < chords.size(); ++i) {
        const Vec2 in = chords[i] - chords[i - 1], out = chords[i + 1] - chords[i];
        const Vec2 step = 50 * (out / length(out) - in / length(in));
        RC_ASSERT(std::abs(step.x) < 1.1 * jerk);
        RC_ASSERT(std::abs(step.y) < 1.1 * 1.5 * jerk);
    }
}

// A right angle at square corner velocity is Klipper's own definition; small turns are what counts.
TEST(VelocityStep, OfAFirmwareIsWhatItPassesCornersAt) {
    Limits limits;
    limits.jerk = {8, 9, 0.4, 1.5};
    EXPECT_TRUE(velocity_step(Firmware::marlin_jerk, limits).allows({8, -9}));
    EXPECT_FALSE(velocity_step(Firmware::prusa, limits).allows({0, 9.1}));
    const double turn = 0.1, half = std::cos(turn / 2);
    const auto passed = [&](double acceleration_deviation) {
        return std::sqrt(acceleration_deviation * half / (1 - half));
    };
    const auto step_at = [&](double speed) { return Vec2{2 * speed * std::sin(turn / 2), 0}; };
    const double klipper =
        passed(limits.square_corner_velocity * limits.square_corner_velocity * 0.41421);
    EXPECT_TRUE(velocity_step(Firmware::klipper, limits).allows(step_at(0.999 * klipper)));
    EXPECT_FALSE(velocity_step(Firmware::klipper, limits).allows(step_at(1.002 * klipper)));
    const double marlin = passed(limits.acceleration * limits.junction_deviation);
    EXPECT_TRUE(velocity_step(Firmware::marlin_jd, limits).allows(step_at(0.999 * marlin)));
    EXPECT_FALSE(velocity_step(Firmware::marlin_jd, limits).allows(step_at(1.002 * marlin)));
}

// Neither smaller nor larger than the circle, and its chords push well above the modes.
TEST(Chords, KeepACirclesAreaAndLeaveTheModes) {
    for (const double radius : {4.2, 17.2, 60.0}) {
        Polyline loop = round_loop({}, radius, 2000);
        loop.push_back(loop.front());
        const ChordOptions options;
        const Ribbon after = chorded(measured(ribbon_of(loop, Role::wall)), options);
        Polyline chords(after.points.begin(), after.points.end() - 1);
        EXPECT_NEAR(signed_area(chords) / (pi * radius * radius), 1, 2e-3 / radius);
        if (radius > 30) continue;  // gentle enough not to matter
        const double chord = distance(after.points[3], after.points[4]);
        EXPECT_GT(50 / chord, 1.2 * options.frequency);
    }
}
