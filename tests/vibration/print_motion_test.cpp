#include "vibration/print_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/planner.h"
#include "vibration/response_meter.h"

namespace bead {
namespace {

std::vector<Command> ring_and_retraction() {
    std::vector<Command> commands;
    Move move{.to = {100, 60, 0.2, 0}, .feed = 100, .role = Role::travel, .bead = {}};
    commands.push_back({move, 1});
    for (int i = 1; i <= 400; ++i) {
        const Vec2 at = Vec2{60, 60} + 40 * unit(2 * pi * i / 200);
        move.to = {at.x, at.y, 0.2, 0.05 * i};
        move.feed = 50;
        move.role = Role::wall;
        commands.push_back({move, i});
    }
    move.to[axis_e] -= 1;
    move.feed = 35;
    move.role = Role::travel;
    commands.push_back({move, 500});
    commands.push_back({Dwell{0.5}, 501});
    return commands;
}

struct Told {
    double duration = 0, length = 0, melt = 0, still = 0;
    Vec2 at;
};

Told told(Firmware firmware, const std::optional<TimeLaw>& law) {
    Told all;
    PrintMotion motion(2.4, law, [&](const MotionSegment& s) {
        all.duration += s.duration;
        all.length += s.length;
        all.melt += s.flow * s.length;
        if (s.length == 0) all.still += s.duration;
        all.at = end(s);
        EXPECT_NEAR(way(s, s.duration), s.length, 1e-6 + 1e-6 * s.length);
    });
    const auto planner =
        make_planner({}, {firmware}, [&](const MotionEvent& event) { motion.add(event); });
    for (const Command& command : ring_and_retraction()) planner->add(command);
    planner->finish();
    motion.finish();
    return all;
}

TEST(PrintMotion, GoesTheWholeWayAndMeltsAllFilament) {
    for (const Firmware firmware : {Firmware::klipper, Firmware::marlin_jd, Firmware::prusa})
        for (const std::optional<TimeLaw>& law :
             {std::optional<TimeLaw>(), std::optional(TimeLaw{.profile = SpeedProfile::jerk_limited,
                                        .acceleration = 1250})}) {
            const Told all = told(firmware, law);
            EXPECT_NEAR(all.length, std::hypot(100, 60) + 2 * 2 * pi * 40, 0.5);
            EXPECT_NEAR(all.melt, 2.4 * 20, 0.1);
            EXPECT_NEAR(distance(all.at, {100, 60}), 0, 0.02);
            EXPECT_GT(all.still, 0.5);
            EXPECT_LT(all.still, 0.7);
        }
}

}  // namespace
}  // namespace bead
