#include "smooth/smooth.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "smooth/engine_block.h"
#include "smooth/metrics.h"
#include "smooth/sliced_section.h"
#include "support/blocks.h"
#include "support/smooth_layers.h"

using namespace bead;
using namespace bead::test;

namespace {

bool same(const Toolpath& a, const Toolpath& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i].points != b[i].points || !(a[i].bead == b[i].bead)) return false;
    return true;
}

// A hole with three walls and infill loops about it, in the middle of a plate with three walls.
Toolpath plate() {
    std::vector<Path> paths;
    for (int i = 0; i < 3; ++i) {
        const Role role = i == 0 ? Role::outer_wall : Role::wall;
        paths.push_back(deposit(role, box_loop({40, 40}, 30 - 0.4 * i, 25 - 0.4 * i), true));
        paths.push_back(deposit(role, round_loop({40, 40}, 6 + 0.4 * i, 40), true));
    }
    for (int i = 0; i < 3; ++i)
        paths.push_back(deposit(Role::infill, round_loop({40, 40}, 9 + 4.5 * i, 60), true));
    return joined_by_travel(paths);
}

// Anything a layer may hold: loops with and without a gap at the seam, lines, of all roles.
Toolpath any_layer() {
    std::vector<Path> paths;
    const int count = *rc::gen::inRange(1, 9);
    for (int i = 0; i < count; ++i) {
        const Vec2 at{number_between(-60, 60), number_between(-60, 60)};
        const double size = number_between(0.5, 20);
        const auto role = static_cast<Role>(*rc::gen::inRange(1, 9));
        const int kind = *rc::gen::inRange(0, 4);
        if (kind == 0) paths.push_back(deposit(role, box_loop(at, size, size / 2), true));
        if (kind == 1)
            paths.push_back(deposit(role, round_loop(at, size, *rc::gen::inRange(3, 60)), true));
        if (kind == 2) paths.push_back(deposit(role, round_loop(at, size, 40), false));
        if (kind == 3)
            paths.push_back(deposit(role, {at, at + Vec2{size, 1}, at + Vec2{0, 2}}, false));
        if (kind == 1 && *rc::gen::inRange(0, 2) == 0)
            paths.push_back(deposit(role, round_loop(at, size + 0.4, 40), true));
    }
    return joined_by_travel(paths);
}

}  // namespace

TEST(Smooth, LeavesALayerWithoutAnythingAsItIs) {
    EXPECT_TRUE(smoothed({}).path.empty());
    Path travel;
    travel.points = {{0, 0, 1}, {5, 0, 1}};
    EXPECT_TRUE(same(smoothed({travel}).path, {travel}));
}

TEST(Smooth, LeavesAShortLineWhereItIs) {
    const Path line = deposit(Role::infill, {{1, 1}, {1.5, 1}}, false);
    SmoothOptions options;
    options.start = {1, 1};
    const Toolpath after = smoothed({line}, options).path;
    ASSERT_EQ(after.size(), 1U);
    EXPECT_EQ(after[0].points.size(), 2U);
    EXPECT_NEAR(volume(after[0]), volume(line), 1e-12);
}

RC_GTEST_PROP(Smooth, DepositsWhatWasThere, ()) {
    const Toolpath layer = any_layer();
    SmoothOptions options;
    options.stages.chains = *rc::gen::inRange(0, 2) == 0;
    options.stages.curves = *rc::gen::inRange(0, 2) == 0;
    options.stages.blends = *rc::gen::inRange(0, 2) == 0;
    options.stages.chords = *rc::gen::inRange(0, 2) == 0;
    options.stages.order = *rc::gen::inRange(0, 2) == 0;
    const SmoothedLayer after = smoothed(layer, options);
    RC_ASSERT(std::abs(total_volume(after.path) / total_volume(layer) - 1) < 1e-9);
    for (const Path& path : after.path) {
        RC_ASSERT(path.points.size() > 1U);
        RC_ASSERT(path.role == Role::travel || path.bead.width > 0);
    }
    for (std::size_t i = 0; i + 1 < after.path.size(); ++i)
        RC_ASSERT(length(after.path[i].points.back() - after.path[i + 1].points.front()) < 1e-5);
    RC_ASSERT(same(after.path, smoothed(layer, options).path));
}

RC_GTEST_PROP(Smooth, KeepsOuterWallsWithinTolerance, ()) {
    const Toolpath layer = any_layer();
    const SmoothedLayer after = smoothed(layer);
    for (const Path& path : layer)
        if (path.role == Role::outer_wall) {
            RC_ASSERT(farthest(line_of(path), after.path, Role::outer_wall) < 0.08);
        }
}

// Where a slicer has put a seam it may stay, with loops wound into one or not. Open lines begin at
// either end.
RC_GTEST_PROP(Smooth, KeepsSeamsIfAsked, ()) {
    const Toolpath layer = any_layer();
    SmoothOptions options;
    options.stages.seams = *rc::gen::inRange(0, 2) == 0;
    options.stages.order = options.stages.seams ? false : *rc::gen::inRange(0, 2) == 0;
    options.stages.chains = *rc::gen::inRange(0, 2) == 0;
    const Toolpath after = smoothed(layer, options).path;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const bool begins = i == 0 || after[i - 1].role == Role::travel;
        if (after[i].role != Role::outer_wall || !begins) continue;
        const auto starts_here = [&](const Path& path) {
            const Vec3 start = after[i].points.front();
            const auto is_end = [&](Vec3 end) { return length(end - start) < 1e-6; };
            return path.role == Role::outer_wall &&
                   (is_end(path.points.front()) || is_end(path.points.back()));
        };
        RC_ASSERT(std::ranges::any_of(layer, starts_here));
    }
}

// Turns of that radius, on either side of either end, and straight between them; in chords within
// 0.1.
RC_GTEST_PROP(Smooth, TravelTurnsWithinItsTolerance, ()) {
    SmoothOptions options;
    options.tolerances.travel = number_between(0.1, 5);
    for (const Path& path : smoothed(any_layer(), options).path) {
        if (path.role != Role::travel) continue;
        const Vec2 from = flat(path.points.front()), to = flat(path.points.back());
        for (const Vec3& point : path.points)
            RC_ASSERT(segment_distance(from, to, flat(point)) <=
                      2 * options.tolerances.travel + 0.2);
    }
}

TEST(Smooth, WindsAPlatesLoops) {
    const Toolpath before = plate();
    const SmoothedLayer after = smoothed(before);
    EXPECT_EQ(after.chains, 2 + (9 - 6) - (after.links - 4));
    EXPECT_GE(after.links, 4);
    for (const Path& path : before) {
        if (path.role == Role::outer_wall) {
            EXPECT_LT(farthest(line_of(path), after.path, path.role), 0.05);
        }
        if (path.role == Role::wall) {
            // Half-way along the links two beads, half a bead off, share a lane.
            EXPECT_LT(farthest(line_of(path), after.path, path.role), 0.21);
        }
        if (path.role == Role::infill) {
            EXPECT_LT(farthest(line_of(path), after.path, path.role), 3.5);
        }
    }
    const PathMetrics a = path_metrics(before), b = path_metrics(after.path);
    EXPECT_LT(b.length, a.length + 6);
    EXPECT_LT(b.turning_points, a.turning_points);
}

TEST(Smooth, LinksStayInsideTheInfill) {
    const Toolpath after = smoothed(plate()).path;
    for (const Vec2 point : points_of(after, Role::infill)) {
        EXPECT_LT(std::abs(point.x - 40), 29.2 - 0.3);
        EXPECT_LT(std::abs(point.y - 40), 24.2 - 0.3);
        EXPECT_GT(distance(point, {40, 40}), 6.8 + 0.3);
    }
}

// Two islands side by side, nearer to each other than loops are apart, with walls between.
TEST(Smooth, LinksDoNotCrossWalls) {
    std::vector<Path> paths;
    for (const double x : {10.0, 31.0}) {
        paths.push_back(deposit(Role::outer_wall, box_loop({x, 20}, 10, 15), true));
        paths.push_back(deposit(Role::infill, box_loop({x, 20}, 9, 14), true));
        paths.push_back(deposit(Role::infill, box_loop({x, 20}, 5, 10), true));
    }
    const Toolpath after = smoothed(joined_by_travel(paths)).path;
    for (const Path& path : after) {
        if (path.role != Role::infill) continue;
        const bool left = path.points.front().x < 20.5;
        for (const Vec3& point : path.points) EXPECT_EQ(point.x < 20.5, left);
    }
}

TEST(Smooth, SmoothingTwiceDoesNoHarm) {
    const Toolpath before = plate();
    const Toolpath once = smoothed(before).path, twice = smoothed(once).path;
    EXPECT_NEAR(total_volume(twice), total_volume(before), 1e-9 * total_volume(before));
    const PathMetrics a = path_metrics(once), b = path_metrics(twice);
    EXPECT_LT(b.length, 1.02 * a.length);
    EXPECT_LT(b.points, 1.25 * a.points);
    for (const Path& path : before)
        if (path.role == Role::outer_wall) {
            EXPECT_LT(farthest(line_of(path), twice, path.role), 0.10);
        }
}

// A nozzle that stands while filament is pulled back gains nothing by turning into its travel, and
// a way without it may be longer.
TEST(Smooth, TravelThatPullsFilamentBackIsStraightAndRare) {
    Toolpath layer = plate();
    for (Path& path : layer) path.retracted = path.role == Role::travel && length(path) > 3;
    const auto retracted = [](const Toolpath& travels) {
        return std::ranges::count_if(travels, [](const Path& path) { return path.retracted; });
    };
    SmoothOptions stopping;
    stopping.retraction = 40;
    const Toolpath after = smoothed(layer, stopping).path;
    for (const Path& path : after) EXPECT_TRUE(!path.retracted || path.points.size() == 2);
    EXPECT_LE(retracted(after), retracted(smoothed(layer).path));
}

TEST(Smooth, MakesTheEngineBlockNoLongerAndLessAngular) {
    const Toolpath before = sliced_section(engine_block(75));
    const SmoothedLayer after = smoothed(before);
    const PathMetrics a = path_metrics(before), b = path_metrics(after.path);
    EXPECT_NEAR(b.volume, a.volume, 1e-9 * a.volume);
    EXPECT_LT(b.length, a.length);
    EXPECT_LT(b.travel, 0.9 * a.travel);
    EXPECT_LT(b.points, 1.2 * a.points);
    EXPECT_LT(b.turning_points, 0.25 * a.turning_points);
    EXPECT_LT(b.windowed_turning_points, 0.45 * a.windowed_turning_points);
}
