#include "strength/sideways_strength.h"

#include <gtest/gtest.h>

#include <tuple>

#include "fem/sideways.h"
#include "strength/cases.h"
#include "strength/strength.h"

namespace bead {
namespace {

// Flat side against slender side: a bar 3 wide and 0.6 thick bends sideways first.
TEST(SidewaysLoad, OfAFlatBarIsEulersAboutItsFlatSide) {
    const Vec2 size{40, 3};
    LoadCase bar = bar_case(size, {-1, 0});
    bar.thickness = 0.6;
    bar.material.poisson = 0;
    const Toolpath layer = solid_bar(size);
    const double euler = pi * pi * 2200 * 3 * 0.6 * 0.6 * 0.6 / 12 / (4 * 40 * 40);
    const auto load = sideways_load({&layer, 1}, bar);
    ASSERT_TRUE(load);
    EXPECT_NEAR(*load, euler, 0.02 * euler);
    const Strength s = strength_of({&layer, 1}, bar, {});
    EXPECT_GT(s.buckling_load, 20 * euler);
    EXPECT_EQ(s.sideways_load, load);
    EXPECT_EQ(s.bears(), *load);
    bar.guided = true;
    const Strength guided = strength_of({&layer, 1}, bar, {});
    EXPECT_FALSE(guided.sideways_load);
    EXPECT_GT(guided.bears(), 5 * euler);
}

TEST(SidewaysLoad, CountsForThinPartsThatNothingGuides) {
    LoadCase bar = bar_case({40, 3}, {-1, 0});
    for (const auto& [thickness, looked_at, counted] :
         {std::tuple{0.6, true, true}, {5.0, true, false}, {6.0, false, false}}) {
        bar.thickness = thickness;
        bar.guided.reset();
        EXPECT_EQ(is_thin(bar), looked_at) << thickness;
        EXPECT_EQ(counts_sideways(bar), counted) << thickness;
        bar.guided = true;
        EXPECT_FALSE(is_thin(bar) || counts_sideways(bar));
        bar.guided = false;
        EXPECT_TRUE(is_thin(bar) && counts_sideways(bar));
    }
}

TEST(SidewaysLoad, OfASolidPartIsItsPlates) {
    const Vec2 size{30, 6};
    LoadCase bar = bar_case(size, {0, -1});
    bar.thickness = 0.6;
    const Toolpath layer = solid_bar(size);
    const SolidBuckling solid = solid_buckling(bar, 0, 0.2);
    const auto printed = sideways_load({&layer, 1}, bar);
    ASSERT_TRUE(printed && solid.sideways);
    EXPECT_NEAR(*printed, *solid.sideways, 0.05 * *solid.sideways);
    EXPECT_GT(solid.in_plane, 5 * *solid.sideways);
}

// A cantilever of narrow section topples at 4.013 sqrt(E I G J) / L² (Prandtl, Michell 1899).
TEST(SolidBuckling, OfANarrowCantileverIsPrandtls) {
    LoadCase bar = bar_case({100, 5}, {0, -1});
    bar.thickness = 0.5;
    bar.material.poisson = 0;
    const double weak = 5 * 0.125 / 12, torsion = 5 * 0.125 / 3 * (1 - 0.63 * 0.1);
    const double known = 4.013 * std::sqrt(2200 * weak * 1100 * torsion) / (100 * 100);
    const SolidBuckling found = solid_buckling(bar, 0, 0.5);
    ASSERT_TRUE(found.sideways);
    EXPECT_NEAR(*found.sideways, known, 0.06 * known);
}

TEST(TwistShare, IsOneForPlatesAndSmallForHighStrips) {
    EXPECT_NEAR(twist_share(1000, 1), 1, 1e-3);
    EXPECT_NEAR(twist_share(1, 1), 3 * 0.1408, 0.002);  // a square
    EXPECT_NEAR(twist_share(0.6, 6), 0.01 * (1 - 0.63 * 0.1), 1e-4);
    EXPECT_LT(twist_share(0.6, 5), twist_share(0.7, 5));
}

TEST(SidewaysLoad, NarrowBeadsTwistMoreEasilyThanASheet) {
    const Vec2 size{40, 6};
    LoadCase bar = bar_case(size, {0, -1});
    bar.thickness = 4.8;
    Toolpath layer = solid_bar(size);
    layer.erase(layer.begin() + 1, layer.end() - 1);  // the outer two beads, and rungs
    for (double x = 0.3; x < size.x; x += 4.925) {
        Path rung = layer.front();
        rung.points = {{x, 0.3, 0}, {x, size.y - 0.3, 0}};
        layer.push_back(rung);
    }
    const auto load = sideways_load({&layer, 1}, bar);
    const SolidBuckling solid = solid_buckling(bar, 0, 0.3);
    ASSERT_TRUE(load && solid.sideways);
    EXPECT_LT(*load, 0.4 * *solid.sideways);
    EXPECT_GT(*load, 0);
}

TEST(SidewaysLoad, IsNoneWhereNothingHangsTogether) {
    const LoadCase bar = bar_case({20, 6}, {1, 0});
    Toolpath layer = solid_bar({20, 6});
    for (Path& path : layer) path.points[0].x = 10;
    EXPECT_FALSE(sideways_load({&layer, 1}, bar));
}

}  // namespace
}  // namespace bead
