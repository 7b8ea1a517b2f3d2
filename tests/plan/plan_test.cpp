#include "plan/plan.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "plan/route.h"
#include "support/layers.h"

namespace bead {
namespace {

using shapes::prism;
using shapes::rectangle;

double relative(double value, double wanted) { return wanted > 0 ? value / wanted - 1 : value; }

Toolpath planned(const Region& region, const PlanOptions& options) {
    return plan(prism(region, 3), options);
}

// For three layers: solid, sparse, solid.
PlanOptions random_options() {
    PlanOptions options;
    options.top_layers = options.bottom_layers = 1;
    options.walls = *rc::gen::inRange(0, 5);
    options.density = *rc::gen::inRange(1, 10) / 10.0;
    options.angle = *rc::gen::inRange(0, 314) / 100.0;
    options.pattern = patterns[*rc::gen::inRange<std::size_t>(0, patterns.size())];
    return options;
}

RC_GTEST_PROP(Plan, EachPathStartsWhereTheLastOneEnded, ()) {
    const Toolpath path =
        planned(shapes::star(*rc::gen::arbitrary<std::uint64_t>()), random_options());
    Vec2 at;
    for (const Path& piece : path) {
        RC_ASSERT(flat(piece.points.front()) == at);
        RC_ASSERT(length(piece) > 0);
        at = flat(piece.points.back());
    }
}

RC_GTEST_PROP(Plan, NothingIsPrintedOutsideTheOutline, ()) {
    const Region region = shapes::star(*rc::gen::arbitrary<std::uint64_t>());
    const PlanOptions options = random_options();
    for (const Path& piece : planned(region, options)) {
        if (piece.role == Role::travel || piece.role == Role::skirt) continue;
        // A bead in a narrow place keeps half as far away.
        const double least = (options.walls == 0 ? 0.25 : 0.5) * spacing(piece.bead) - 1e-3;
        for (const Vec3 p : piece.points) {
            RC_ASSERT(contains(region, flat(p)));
            RC_ASSERT(boundary_distance(region, flat(p)) > least);
        }
    }
}

RC_GTEST_PROP(Plan, TravelDepositsNothingAndTheRestIsAccountedFor, ()) {
    const Toolpath path =
        planned(shapes::star(*rc::gen::arbitrary<std::uint64_t>()), random_options());
    double sum = 0;
    for (const Path& piece : path) {
        sum += volume(piece);
        RC_ASSERT(piece.role != Role::travel || volume(piece) == 0);
    }
    const Volumes v = deposited_volumes(path);
    RC_ASSERT(v.other == 0 && v.support == 0);
    RC_ASSERT(std::abs(v.wall + v.skin + v.infill + v.skirt - sum) < 1e-9 * sum);
}

RC_GTEST_PROP(Plan, TurningThePartAndItsLinesTurnsTheToolpath, ()) {
    const std::vector<LayerParts> parts =
        parts_of(prism(shapes::star(*rc::gen::arbitrary<std::uint64_t>()), 3), random_options());
    const LayerParts& layer = parts[1];
    const double angle = *rc::gen::inRange(0, 628) / 100.0;
    const LayerParts turned = moved(layer, angle, {0, 0}, {0, 0});
    const Volumes a = deposited_volumes(plan_layer(layer, {patterns[0], 0.3}, {}, {}, {}));
    const Volumes b = deposited_volumes(plan_layer(turned, {patterns[0], 0.3 + angle}, {}, {}, {}));
    RC_ASSERT(std::abs(relative(a.infill, b.infill)) < 0.05);
    RC_ASSERT(std::abs(relative(a.wall, b.wall)) < 1e-9);
}

TEST(SlowPlan, DepositsWhatIsAskedFor) {
    for (const auto& [name, region] : shapes::some_regions())
        for (const NamedPattern& pattern : patterns)
            for (const double density : {0.1, 0.3, 1.0})
                for (int walls = 0; walls <= 4; walls += 2) {
                    PlanOptions options;
                    options.walls = walls;
                    options.density = density;
                    options.pattern = pattern;
                    options.top_layers = options.bottom_layers = 2;
                    const std::vector<Layer> layers = prism(region, 6);
                    const Volumes asked = asked_volumes(parts_of(layers, options), options);
                    const Volumes got = deposited_volumes(plan(layers, options));
                    const std::string where = name + ", " + std::string(pattern.name) + ", " +
                                              std::to_string(density) + ", walls " +
                                              std::to_string(walls);
                    EXPECT_NEAR(relative(got.wall, asked.wall), 0, 1e-6) << where;
                    EXPECT_NEAR(relative(got.skirt, asked.skirt), 0, 1e-6) << where;
                    EXPECT_NEAR(relative(got.skin, asked.skin), 0, 0.03) << where;
                    EXPECT_NEAR(relative(got.infill, asked.infill), 0, 0.03) << where;
                }
}

TEST(Plan, LinesOfPatternsWithADirectionCrossFromLayerToLayer) {
    EXPECT_EQ(layer_angle(0.5, 6), 0.5);
    EXPECT_NEAR(layer_angle(0.5, 7), 0.5 + pi / 2, 1e-12);
}

TEST(Plan, TheFirstLayerGoesAtItsOwnSpeedAfterTheSkirt) {
    PlanOptions options;
    options.speeds.first_layer = 17;
    options.first_layer_acceleration = 500;
    const Toolpath path = planned(rectangle({10, 10}, {40, 30}), options);
    EXPECT_EQ(path[1].role, Role::skirt);
    for (const Path& piece : path) {
        const bool first = piece.points.front().z < 0.3;
        const bool prints = piece.role != Role::travel;
        EXPECT_EQ(piece.acceleration, first && prints ? 500 : 0);
        EXPECT_EQ(piece.speed == 17, first && prints);
    }
}

TEST(Plan, OnlyLongTravelThatLeavesTheIslandIsRetracted) {
    const Region two = united(rectangle({0, 0}, {12, 15}), rectangle({20, 3}, {40, 16}));
    PlanOptions options;
    long between = 0;
    for (const Path& piece : plan(prism(two, 12), options)) {
        if (piece.role != Role::travel || piece.points.front().z < 0.3) continue;
        const Vec2 a = flat(piece.points.front()), b = flat(piece.points.back());
        const bool leaves = (a.x < 15) != (b.x < 15);
        between += leaves ? 1 : 0;
        EXPECT_EQ(piece.retracted, leaves);
    }
    EXPECT_GE(between, 11);
}

TEST(Route, StaysInsideSeesHolesAndBays) {
    const Region ring = shapes::ring(20, 9);
    EXPECT_TRUE(stays_inside(ring, {15, 0}, {0, 15}));
    EXPECT_FALSE(stays_inside(ring, {15, 0}, {-15, 1}));
    EXPECT_FALSE(stays_inside(ring, {25, 0}, {15, 0}));
    EXPECT_FALSE(stays_inside(ring, {0, 0}, {1, 1}));
    EXPECT_FALSE(stays_inside(shapes::ell(), {39, 11}, {13, 29}));
}

TEST(Plan, NothingGivesNothing) {
    EXPECT_TRUE(plan({}, {}).empty());
    EXPECT_TRUE(plan(shapes::stacked({{}, {}}), {}).empty());
}

TEST(Plan, IsTheSameForAnyNumberOfThreads) {
    PlanOptions options;
    options.threads = 1;
    const std::vector<Layer> layers = prism(shapes::star(3), 20);
    const Toolpath one = plan(layers, options);
    options.threads = 4;
    const Toolpath four = plan(layers, options);
    ASSERT_EQ(one.size(), four.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].points, four[i].points);
}

}  // namespace
}  // namespace bead
