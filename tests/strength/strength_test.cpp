#include "strength/strength.h"

#include <gtest/gtest.h>

#include "strength/anisotropic.h"
#include "strength/cases.h"
#include "strength/failure_index.h"
#include "strength/printed_pixels.h"

namespace bead {
namespace {

TEST(Strength, ASolidBarBreaksAtItsStrengthTimesItsSection) {
    const Vec2 size{30, 3};
    const LoadCase bar = bar_case(size, {100, 0});
    const Toolpath layer = solid_bar(size);
    const Strength s = strength_of({&layer, 1}, bar, {.buckling = false});
    ASSERT_TRUE(s.holds);
    EXPECT_NEAR(s.failure_load, 35 * 3 * 1.2, 0.5);
    EXPECT_NEAR(s.stiffness, 2200 * 3 * 1.2 / 30, 0.02 * 2200 * 3 * 1.2 / 30);
    EXPECT_NEAR(s.volume, 30 * 3 * 1.2, 1e-6);
    EXPECT_NEAR(s.mass, 30 * 3 * 1.2 * 1.04e-3, 1e-9);
    EXPECT_NEAR(s.covered, 90, 0.5);
}

TEST(Strength, ASlenderBarBucklesAsEulerSays) {
    const Vec2 size{40, 1.2};
    LoadCase bar = bar_case(size, {-10, 0});
    bar.guided = true;
    const Toolpath layer = solid_bar(size);
    const Strength s = strength_of({&layer, 1}, bar, {});
    const double inertia = 1.2 * 1.2 * 1.2 * 1.2 / 12;
    const double euler = pi * pi * 2200 * inertia / (4 * 40 * 40);
    ASSERT_TRUE(s.holds);
    EXPECT_NEAR(s.buckling_load, euler, 0.02 * euler);
    EXPECT_NEAR(s.buckling_factor, euler / 10, 0.02 * euler / 10);
    EXPECT_EQ(s.bears(), s.buckling_load);
}

TEST(Strength, DoesNotChangeWithTheLoadsSize) {
    const Vec2 size{20, 3};
    const Toolpath layer = solid_bar(size);
    const Strength light = strength_of({&layer, 1}, bar_case(size, {0, -1}), {});
    const Strength heavy = strength_of({&layer, 1}, bar_case(size, {0, -50}), {});
    EXPECT_NEAR(light.failure_load, heavy.failure_load, 1e-6 * heavy.failure_load);
    EXPECT_NEAR(light.buckling_load, heavy.buckling_load, 1e-3 * heavy.buckling_load);
    EXPECT_NEAR(light.stiffness, heavy.stiffness, 1e-6 * heavy.stiffness);
}

// The file's layers need not be as high as the case says.
TEST(Strength, CountsLayersByTheirHeight) {
    const Vec2 size{20, 3};
    const LoadCase bar = bar_case(size, {1, 0});
    const Toolpath whole = solid_bar(size);
    const auto of_height = [&](Toolpath layer, double height) {
        for (Path& path : layer) path.bead = {spacing(path.bead) + (1 - pi / 4) * height, height};
        return layer;
    };
    const std::vector<Toolpath> thin(7, of_height(whole, 0.2));
    const Strength one = strength_of({&whole, 1}, bar, {.pixel = 0.2, .buckling = false});
    const Strength many = strength_of(thin, bar, {.pixel = 0.2, .buckling = false});
    EXPECT_NEAR(many.volume, one.volume, 1e-9);
    EXPECT_NEAR(many.stiffness, one.stiffness, 1e-6 * one.stiffness);
    EXPECT_NEAR(many.failure_load, one.failure_load, 1e-6 * one.failure_load);

    Toolpath half = whole;
    half.resize(3);  // of 5 beads
    const std::vector<Toolpath> mixed{of_height(whole, 0.45), of_height(half, 0.15)};
    const Strength mean = strength_of(mixed, bar, {.pixel = 0.2, .buckling = false});
    EXPECT_NEAR(mean.volume, (0.75 + 0.25 * 3 / 5) * one.volume, 1e-9);
}

TEST(Strength, TakesTheWorstOfARange) {
    const Vec2 size{20, 3};
    const Toolpath layer = solid_bar(size);
    LoadCase bar = bar_case(size, {50, 0});
    const double straight = strength_of({&layer, 1}, bar, {.buckling = false}).failure_load;
    bar.situations[0].loads[0].turn = 0.2;
    const double turned = strength_of({&layer, 1}, bar, {.buckling = false}).failure_load;
    bar.situations[0].loads[0].turn = 0;
    bar.situations[0].loads[0].force = rotated(Vec2{50, 0}, unit(0.2));
    const double alone = strength_of({&layer, 1}, bar, {.buckling = false}).failure_load;
    EXPECT_LT(turned, 0.8 * straight);
    EXPECT_NEAR(turned, alone, 1e-3 * alone);
}

TEST(Strength, WhatHangsOnNothingHoldsNothing) {
    const LoadCase bar = bar_case({20, 6}, {1, 0});
    Toolpath layer = solid_bar({20, 6});
    for (Path& path : layer) path.points[0].x = 10;
    EXPECT_FALSE(strength_of({&layer, 1}, bar, {}).holds);
}

TEST(Strength, APeakIsNoLessThanTheFirstFailure) {
    const Vec2 size{20, 3};
    const Toolpath layer = solid_bar(size);
    const Strength s =
        strength_of({&layer, 1}, bar_case(size, {0, -1}),
                    {.pixel = 0.2, .buckling = false, .progressive = true, .anisotropic = true});
    ASSERT_TRUE(s.peak_load && s.anisotropic_load);
    EXPECT_GE(*s.peak_load, s.failure_load);
    EXPECT_LE(*s.anisotropic_load, 1.01 * s.failure_load);
}

TEST(FailureIndex, IsOneAtTheMaterialsStrength) {
    const SolidMaterial abs;
    EXPECT_NEAR(failure_index({35, 0, 0}, abs), 1, 1e-12);
    EXPECT_NEAR(failure_index({0, -52, 0}, abs), 1, 1e-12);
    EXPECT_NEAR(failure_index({0, 0, 35}, abs), 1, 1e-12);
    EXPECT_NEAR(hashin_index({35, 0, 0}, abs, {}), 1, 1e-12);
    EXPECT_NEAR(hashin_index({0, 21, 0}, abs, {}), 1, 1e-12);
    EXPECT_NEAR(hashin_index({0, 0, 17.5}, abs, {}), 1, 1e-12);
}

TEST(AveragedOverSolid, IsTheMeanOfTheSolidOnly) {
    PixelModel model;
    model.grid = {{0, 0}, 0.1, 30, 30};
    model.factor.assign(900, 0.0);
    std::vector<double> values(900, 7.0);
    for (int j = 10; j < 20; ++j)
        for (int i = 10; i < 20; ++i) {
            model.factor[model.grid.pixel(i, j)] = 1;
            values[model.grid.pixel(i, j)] = i < 15 ? 1 : 3;
        }
    const std::vector<double> mean = averaged_over_solid(model, values, 0.35);
    EXPECT_NEAR(mean[model.grid.pixel(11, 15)], 1, 1e-12);
    EXPECT_NEAR(mean[model.grid.pixel(18, 15)], 3, 1e-12);
    EXPECT_GT(mean[model.grid.pixel(15, 15)], 1.5);
    EXPECT_EQ(mean[model.grid.pixel(2, 2)], 0);
}

TEST(PrintedPixels, BeadsSideBySideLeaveNoGap) {
    const PixelGrid grid{{0, 0}, 0.1, 200, 30};
    const std::vector<double> solid = printed_pixels(solid_bar({20, 3}), grid);
    for (const double pixel : solid) EXPECT_EQ(pixel, 1);
}

}  // namespace
}  // namespace bead
