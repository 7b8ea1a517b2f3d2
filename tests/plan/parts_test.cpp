#include "plan/parts.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "plan/skin.h"
#include "plan/walls.h"
#include "support/layers.h"

namespace bead {
namespace {

using shapes::prism;
using shapes::rectangle;

constexpr double tolerance = 1e-4;  // mm

double material_area(const LayerParts& layer, Role role) {
    double sum = 0;
    for (const Island& island : layer.islands)
        for (const FillArea& area : island.fills)
            if (area.role == role) sum += bead::area(area.material);
    return sum;
}

double wall_length(const LayerParts& layer) {
    double sum = 0;
    for (const Island& island : layer.islands)
        for (const WallLoop& wall : island.walls) sum += loop_length(wall.points);
    return sum;
}

RC_GTEST_PROP(Parts, WallsKeepHalfABeadFromTheOutline, ()) {
    const Region region = shapes::star(*rc::gen::arbitrary<std::uint64_t>());
    PlanOptions options;
    options.walls = *rc::gen::inRange(1, 5);
    for (const LayerParts& layer : parts_of(prism(region, 2), options))
        for (const Island& island : layer.islands)
            for (const WallLoop& wall : island.walls)
                for (const Vec2 p : wall.points) {
                    RC_ASSERT(contains(region, p));
                    RC_ASSERT(boundary_distance(region, p) > layer.bead.width / 2 - tolerance);
                }
}

RC_GTEST_PROP(Parts, FillsLieInTheirMaterialAndWhatIsFilledLiesInsideTheWalls, ()) {
    const Region region = shapes::star(*rc::gen::arbitrary<std::uint64_t>());
    PlanOptions options;
    options.walls = *rc::gen::inRange(0, 4);
    options.top_layers = options.bottom_layers = 1;
    for (const LayerParts& layer : parts_of(prism(region, 3), options))
        for (const Island& island : layer.islands)
            for (const FillArea& fill : island.fills) {
                RC_ASSERT(area(difference(fill.centre, fill.material)) < 1e-3);
                const double depth =
                    options.walls == 0
                        ? 0
                        : layer.bead.width / 2 + (options.walls - 0.5) * spacing(layer.bead);
                RC_ASSERT(area(difference(fill.material, offset(region, -depth))) < 0.01);
            }
}

TEST(Parts, WallsAndMaterialTileTheOutline) {
    for (const auto& [name, region] : shapes::some_regions()) {
        const LayerParts layer = parts_of(prism(region, 1), {}).front();
        const double covered = wall_length(layer) * spacing(layer.bead) +
                               material_area(layer, Role::top_skin) +
                               material_area(layer, Role::skin);
        // The discs at the outer bead's side do not reach the whole outline.
        const double rounding = (layer.bead.width - spacing(layer.bead)) / 2;
        EXPECT_NEAR(covered / area(offset(region, -rounding)), 1, 0.005) << name;
    }
}

TEST(Parts, WallsThatDoNotFitAreLeftOut) {
    PlanOptions options;
    options.walls = 3;
    const auto walls = [&](double width) {
        return parts_of(prism(rectangle({0, 0}, {width, 20}), 1), options)
            .front()
            .islands.front()
            .walls.size();
    };
    EXPECT_EQ(walls(0.4), 0U);
    EXPECT_EQ(walls(0.9), 1U);
    EXPECT_EQ(walls(1.8), 2U);
    EXPECT_EQ(walls(5), 3U);
}

TEST(Parts, InnerWallsComeBeforeTheOuterOneOfTheSameOutline) {
    const LayerParts layer = parts_of(prism(shapes::ring(20, 9), 1), {}).front();
    std::vector<Role> roles;
    for (const WallLoop& wall : layer.islands.front().walls) roles.push_back(wall.role);
    EXPECT_EQ(roles, (std::vector{Role::wall, Role::outer_wall, Role::wall, Role::outer_wall}));
}

TEST(Parts, ALoopStartsAtItsSharpestCornerAndARoundOneAtTheRear) {
    EXPECT_EQ(from_seam({{0, 0}, {10, 0}, {10, 10}, {-40, 10}}).front(), (Vec2{-40, 10}));
    EXPECT_EQ(from_seam({{0, 0}, {10, 0}, {10, 10}, {0, 10}}).front(), (Vec2{10, 10}));
    EXPECT_NEAR(from_seam(shapes::regular(5, 40)).front().y, 5, 1e-9);
}

TEST(Parts, SkinsOfASteppedPyramidLieOnItsSteps) {
    const int thick = 10;
    PlanOptions options;
    options.top_layers = 3;
    options.bottom_layers = 2;
    const std::vector<double> widths{40, 30, 20};
    const std::vector<LayerParts> parts = parts_of(shapes::stepped_pyramid(widths, thick), options);
    const double depth = options.bead_width / 2 + 1.5 * spacing(parts[0].bead);
    const auto inside = [&](double width) { return (width - 2 * depth) * (width - 2 * depth); };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t step = i / thick, left = thick - 1 - i % thick;
        const double whole = inside(widths[step]);
        const double next = step + 1 < widths.size() ? widths[step + 1] * widths[step + 1] : 0;
        const double top = left == 0 ? whole - next : 0;
        const double skin = i < 2 ? whole : left > 0 && left < 3 ? whole - next : 0;
        EXPECT_NEAR(material_area(parts[i], Role::top_skin), top, 0.01) << i;
        EXPECT_NEAR(material_area(parts[i], Role::skin), skin, 0.01) << i;
        EXPECT_NEAR(material_area(parts[i], Role::infill), whole - top - skin, 0.01) << i;
    }
}

TEST(Parts, AnOverhangIsSolidBelow) {
    std::vector<Region> regions(8, rectangle({0, 0}, {20, 20}));
    regions.resize(16, rectangle({0, 0}, {40, 20}));
    const std::vector<LayerParts> parts = parts_of(shapes::stacked(regions), {});
    EXPECT_GT(material_area(parts[8], Role::skin), 18 * 17);
    EXPECT_GT(material_area(parts[11], Role::skin), 18 * 17);
    EXPECT_GT(material_area(parts[11], Role::infill), 15 * 15);
    EXPECT_EQ(material_area(parts[11], Role::top_skin), 0);
}

TEST(Parts, DensityOneIsSolidAndDensityZeroIsHollow) {
    PlanOptions options;
    options.top_layers = options.bottom_layers = 0;
    for (const double density : {0.0, 0.5, 1.0}) {
        options.density = density;
        const LayerParts layer = parts_of(prism(rectangle({0, 0}, {20, 20}), 5), options)[2];
        EXPECT_EQ(material_area(layer, Role::infill) > 0, density == 0.5);
        EXPECT_EQ(material_area(layer, Role::skin) > 0, density == 1.0);
    }
}

RC_GTEST_PROP(Parts, MovingCommutesWithTakingApart, ()) {
    std::vector<Layer> layers;
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    for (const double size : {1.0, 0.8})
        for (int i = 0; i < 4; ++i) {
            Region region = shapes::star(seed);
            for (Vec2& p : region.front().outer) p = size * p;
            layers.push_back({0.2 * static_cast<double>(layers.size() + 1), 0.2, region});
        }
    const double angle = *rc::gen::inRange(0, 628) / 100.0;
    const Vec2 about{3, -2}, shift{100, 50};
    const std::vector<LayerParts> parts = parts_of(layers, {});
    for (Layer& layer : layers) layer.region = moved(layer.region, angle, about, shift);
    const std::vector<LayerParts> expected = parts_of(layers, {});
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const LayerParts turned = moved(parts[i], angle, about, shift);
        RC_ASSERT(std::abs(wall_length(turned) - wall_length(expected[i])) < 0.01);
        RC_ASSERT(turned.islands.size() == expected[i].islands.size());
        for (const Role role : {Role::skin, Role::top_skin, Role::infill})
            RC_ASSERT(std::abs(material_area(turned, role) - material_area(expected[i], role)) <
                      0.05);
        const Region a{turned.islands.front().outline}, b{expected[i].islands.front().outline};
        RC_ASSERT(area(difference(a, b)) + area(difference(b, a)) < 1e-3);
    }
}

TEST(Parts, MovingTakesEverythingAlong) {
    const std::vector<LayerParts> parts = parts_of(prism(rectangle({0, 0}, {20, 10}), 3), {});
    const LayerParts turned = moved(parts.front(), pi / 2, {0, 0}, {5, 6});
    EXPECT_NEAR(distance(turned.centre, {0, 16}), 0, 1e-9);
    const Box2 box = bounds(turned.skirt.front());
    EXPECT_NEAR(distance(box.centre(), turned.centre), 0, 0.02);
    const Region& centre = turned.islands.front().fills.front().centre;
    EXPECT_NEAR(distance(bounds(centre).centre(), turned.centre), 0, 1e-5);
}

TEST(Parts, TheSkirtKeepsItsDistance) {
    PlanOptions options;
    options.skirt_loops = 2;
    const Region region = shapes::star(5);
    const std::vector<LayerParts> parts = parts_of(prism(region, 2), options);
    ASSERT_EQ(parts[0].skirt.size(), 2U);
    EXPECT_TRUE(parts[1].skirt.empty());
    for (const Polyline& loop : parts[0].skirt)
        for (const Vec2 p : loop)
            EXPECT_GT(boundary_distance(region, p),
                      options.skirt_gap + options.first_layer_width / 2 - 0.02);
}

RC_GTEST_PROP(Skin, RunningIntersectionsAreThoseOfEachWindow, ()) {
    std::vector<Region> regions;
    for (int i = 0; i < 12; ++i) {
        const double x = *rc::gen::inRange(0, 20), y = *rc::gen::inRange(0, 20);
        regions.push_back(rectangle({x, y}, {x + 30, y + 25}));
    }
    const int count = *rc::gen::inRange(1, 8);
    const std::vector<Region> runs = running_intersections(regions, count, 1);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        Region slow = i + static_cast<std::size_t>(count) <= regions.size() ? regions[i] : Region{};
        for (std::size_t k = 1; k < static_cast<std::size_t>(count) && !slow.empty(); ++k)
            slow = intersection(slow, regions[i + k]);
        RC_ASSERT(std::abs(area(runs[i]) - area(slow)) < 1e-6);
    }
}

}  // namespace
}  // namespace bead
