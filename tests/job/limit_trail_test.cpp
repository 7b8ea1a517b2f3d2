#include "job/limit_trail.h"

#include <gtest/gtest.h>

#include "motion/limit_changes.h"

namespace bead {
namespace {

TEST(LimitTrail, TellsWhatChangedFirstWhereAndHowOften) {
    LimitTrail trail;
    Limits limits;
    const auto tell = [&](const SetLimits& told, std::int64_t line) {
        const Limits before = limits;
        limits = changed(limits, told);
        trail.note(told, line, before, limits);
    };
    tell({.acceleration = limits.acceleration}, 5);  // as it was
    tell({.acceleration = 800}, 12);
    tell({.acceleration = 800}, 13);
    tell({.acceleration = 900, .travel_acceleration = 1000}, 20);
    tell({.jerk = {std::nullopt, 0, std::nullopt, 1}}, 30);  // 0 is no jerk

    const auto printing = trail.change(named_limit("acceleration_mm_s2"));
    ASSERT_TRUE(printing);
    EXPECT_EQ(printing->times, 2);
    EXPECT_EQ(printing->first_line, 12);
    EXPECT_EQ(printing->command, "M204");
    EXPECT_EQ(trail.change(named_limit("travel_acceleration_mm_s2"))->first_line, 20);
    EXPECT_EQ(trail.change(named_limit("jerk_mm_s"))->command, "M205");
    EXPECT_FALSE(trail.change(named_limit("max_feedrate_mm_s")));
}

TEST(LimitTrail, NamesTheCommandOfEachLimit) {
    EXPECT_EQ(command_of({.max_acceleration = {1}}), "M201");
    EXPECT_EQ(command_of({.max_feedrate = {1}}), "M203");
    EXPECT_EQ(command_of({.travel_acceleration = 1}), "M204");
    EXPECT_EQ(command_of({.jerk = {1}}), "M205");
    EXPECT_EQ(command_of({.junction_deviation = 1}), "M205");
    EXPECT_EQ(command_of({.square_corner_velocity = 1}), "SET_VELOCITY_LIMIT");
    EXPECT_EQ(command_of({.max_acceleration_head = 1}), "M204 or SET_VELOCITY_LIMIT");
}

}  // namespace
}  // namespace bead
