#include "study/asked_speeds.h"

#include <gtest/gtest.h>

namespace bead {
namespace {

Command move(const Position& to, double feed) {
    Move move;
    move.to = to;
    move.feed = feed;
    return {move, 0};
}

TEST(AskedSpeeds, AreTheFeedsProjectedOntoTheAxes) {
    AskedSpeeds asked;
    asked.add(move({30, 40, 0, 5}, 100));
    EXPECT_DOUBLE_EQ(asked.path(), 100);
    EXPECT_EQ(asked.axes(), (PerAxis<double>{60, 80, 0, 10}));
}

TEST(AskedSpeeds, OfTheFilamentAloneAreNotThePaths) {
    AskedSpeeds asked;
    asked.add(move({0, 0, 0, -2}, 40));
    EXPECT_EQ(asked.path(), 0);
    EXPECT_EQ(asked.axes()[axis_e], 40);
}

TEST(AskedSpeeds, FollowTheHeadWhereItIsCalledElsewhere) {
    AskedSpeeds asked;
    asked.add({SetPosition{{10, {}, {}, {}}}, 0});
    asked.add(move({10, 0, 5, 0}, 7));  // up alone
    asked.add({Home{{false, false, true}}, 0});
    asked.add(move({10, 0, 0, 0}, 90));  // nowhere
    EXPECT_EQ(asked.axes(), (PerAxis<double>{0, 0, 7, 0}));
    EXPECT_EQ(asked.path(), 7);
}

TEST(AskedSpeeds, OfAnArcAreThoseOfItsPlane) {
    AskedSpeeds asked;
    Arc arc;
    arc.end.to = {10, 0, 0, 1};
    arc.end.feed = 30;
    asked.add({arc, 0});
    EXPECT_EQ(asked.path(), 30);
    EXPECT_EQ(asked.axes(), (PerAxis<double>{30, 30, 0, 0}));
}

}  // namespace
}  // namespace bead
