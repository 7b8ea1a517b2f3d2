// When filament is pulled back for new travel: as the layer did it.
#include "smooth/travel_kind.h"

#include <gtest/gtest.h>

#include "smooth/metrics.h"
#include "smooth/walls.h"
#include "support/smooth_layers.h"

namespace bead {
namespace {

using test::box_loop;
using test::deposit;

Path travel(const Polyline& line, bool retracted, double speed = 150) {
    Path path;
    path.speed = speed;
    path.acceleration = 700;
    path.retracted = retracted;
    for (const Vec2 point : line) path.points.push_back(at_height(point, 0.2));
    return path;
}

// A square wall around the origin, 20 mm wide.
Toolpath walled(const std::vector<Path>& travels) {
    Toolpath layer = travels;
    layer.push_back(deposit(Role::outer_wall, box_loop({}, 10, 10), true));
    return layer;
}

const Polyline inside{{-5, 0}, {5, 0}}, across{{5, 0}, {15, 0}}, hop{{5, 0}, {6, 0}};

TEST(TravelKind, goes_as_the_layer_went) {
    const TravelKind kind(walled({travel(inside, true)}));
    const Path path = kind.path_along(across, 0.4);
    EXPECT_EQ(path.role, Role::travel);
    EXPECT_EQ(path.speed, 150);
    EXPECT_EQ(path.acceleration, 700);
    ASSERT_EQ(path.points.size(), 2U);
    EXPECT_EQ(path.points[1].z, 0.4);
}

TEST(TravelKind, goes_as_most_of_the_way_not_as_a_wipe_that_came_first) {
    const Toolpath layer =
        walled({travel(hop, false, 80), travel(inside, true), travel(hop, false, 80)});
    EXPECT_EQ(usual_pace(layer), (TravelPace{150, 700}));
    EXPECT_EQ(TravelKind(layer).path_along(across, 0.4).speed, 150);
}

TEST(TravelKind, retracts_from_the_length_on_from_which_the_layer_did) {
    const TravelKind kind(walled({travel(inside, true), travel(hop, false)}));
    EXPECT_TRUE(kind.path_along(inside, 0).retracted);
    EXPECT_TRUE(kind.path_along(across, 0).retracted);
    EXPECT_FALSE(kind.path_along(hop, 0).retracted);
    EXPECT_FALSE(kind.path_along({{0, 0}, {9, 0}}, 0).retracted);
}

TEST(TravelKind, looks_at_the_walls_where_longer_travel_was_not_retracted) {
    const TravelKind kind(walled({travel(inside, false), travel({{9, 0}, {12, 0}}, true)}));
    EXPECT_FALSE(kind.path_along(inside, 0).retracted);
    EXPECT_TRUE(kind.path_along(across, 0).retracted);
    EXPECT_FALSE(kind.path_along({{9, 0}, {11, 0}}, 0).retracted);  // too short
}

TEST(TravelKind, of_a_layer_without_travel_is_the_usual_one) {
    const TravelKind kind(walled({}));
    EXPECT_EQ(kind.path_along(inside, 0).speed, 120);
    EXPECT_FALSE(kind.path_along(inside, 0).retracted);
    EXPECT_TRUE(kind.path_along(across, 0).retracted);
}

TEST(Walls, are_not_crossed_by_what_only_begins_there) {
    const Walls walls(walled({}));
    EXPECT_TRUE(walls.are_crossed_by(across, 0));
    EXPECT_TRUE(walls.are_crossed_by({{0, 0}, {9, 3}, {11, 3}}, 0.3));
    EXPECT_FALSE(walls.are_crossed_by(inside, 0));
    EXPECT_FALSE(walls.are_crossed_by({{9.9, 0}, {15, 0}}, 0.3));
    EXPECT_TRUE(walls.are_crossed_by({{9.9, 0}, {15, 0}}, 0.05));
    EXPECT_FALSE(walls.are_crossed_by({{9.9, 0}, {10.1, 0}}, 0.3));  // nothing is left of it
    EXPECT_FALSE(walls.are_crossed_by({}, 0.3));
}

}  // namespace
}  // namespace bead
