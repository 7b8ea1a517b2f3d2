// What may be asked of skin: widths, speeds and patterns of its own where it lies.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "plan/plan.h"
#include "support/layers.h"

namespace bead {
namespace {

// Five layers: bottom, sparse, skin on sparse, skin, top.
PlanOptions five_layers() {
    PlanOptions options;
    options.walls = options.skirt_loops = 0;
    options.bottom_layers = 1;
    options.top_layers = 3;
    return options;
}

Toolpath layer_of(const Toolpath& path, int index) {
    Toolpath layer;
    const double z = (index + 1) * shapes::layer_height;
    for (const Path& piece : path)
        if (piece.role != Role::travel && std::abs(piece.points.front().z - z) < 1e-9)
            layer.push_back(piece);
    return layer;
}

Toolpath planned(const PlanOptions& options) {
    return plan(shapes::prism(shapes::rectangle({0, 0}, {30, 20}), 5), options);
}

bool before(Vec3 a, Vec3 b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

// In an order that does not tell from where the layer was begun.
Toolpath sorted(Toolpath layer) {
    for (Path& piece : layer)
        if (before(piece.points.back(), piece.points.front())) std::ranges::reverse(piece.points);
    std::ranges::sort(layer, before, [](const Path& piece) { return piece.points.front(); });
    return layer;
}

bool same(const Toolpath& one, const Toolpath& other) {
    const Toolpath a = sorted(one), b = sorted(other);
    return std::ranges::equal(a, b, [](const Path& p, const Path& q) {
        return p.role == q.role && p.bead == q.bead && p.speed == q.speed &&
               p.acceleration == q.acceleration && p.points == q.points;
    });
}

TEST(SkinLooks, WhatLiesOnInfillHasItsOwnSpeedAccelerationAndWidth) {
    PlanOptions options = five_layers();
    const Toolpath usual = planned(options);
    options.speeds.over_infill = 17;
    options.over_infill_acceleration = 345;
    options.over_infill_width = 0.6;
    const Toolpath path = planned(options);
    for (const Path& piece : layer_of(path, 2)) {
        EXPECT_EQ(piece.speed, 17);
        EXPECT_EQ(piece.acceleration, 345);
        EXPECT_NEAR(piece.bead.width, 0.6, 0.02);
    }
    for (const int other : {0, 1, 3, 4})
        EXPECT_TRUE(same(layer_of(path, other), layer_of(usual, other))) << other;
}

TEST(SkinLooks, TheTopHasItsOwnWidth) {
    PlanOptions options = five_layers();
    options.top_skin_width = 0.3;
    const Toolpath path = planned(options);
    for (const Path& piece : layer_of(path, 4)) EXPECT_NEAR(piece.bead.width, 0.3, 0.02);
    for (const Path& piece : layer_of(path, 3)) EXPECT_NEAR(piece.bead.width, 0.45, 0.02);
}

TEST(SkinLooks, TheBottomMayHaveThePattern) {
    for (const NamedPattern& pattern : patterns) {
        PlanOptions options = five_layers();
        options.pattern = pattern;
        const Toolpath usual = planned(options);
        options.pattern_on_bottom = true;
        const Toolpath path = planned(options);
        EXPECT_EQ(same(layer_of(path, 0), layer_of(usual, 0)), pattern.has_direction)
            << pattern.name;
        for (const int other : {1, 2, 3, 4})
            EXPECT_TRUE(same(layer_of(path, other), layer_of(usual, other))) << pattern.name;
        double laid = 0;
        for (const Path& piece : layer_of(path, 0)) laid += volume(piece);
        EXPECT_NEAR(laid, 30 * 20 * shapes::layer_height, 0.01 * laid) << pattern.name;
    }
}

}  // namespace
}  // namespace bead
