#include "toolpath/laid_layers.h"

#include <gtest/gtest.h>

namespace bead {
namespace {

constexpr double filament = pi / 4 * 1.75 * 1.75;  // mm²

Command move(double x, double y, double z, double e, Role role = Role::infill) {
    Move to;
    to.to = {x, y, z, e};
    to.feed = 40;
    to.role = role;
    return {to};
}

std::vector<LaidLayer> laid(const std::vector<Command>& commands, double height = 0.2) {
    LaidLayers layers(1.75, height);
    for (const Command& command : commands) layers.add(command);
    return std::move(layers).finished();
}

double volume(const std::vector<LaidLayer>& layers) {
    double sum = 0;
    for (const LaidLayer& layer : layers)
        for (const Path& path : layer.paths) sum += volume(path);
    return sum;
}

// All filament is found again, and no travel.
TEST(LaidLayers, LayTheFilamentThatWentIn) {
    const auto layers = laid({move(10, 10, 0.2, 0, Role::travel), move(20, 10, 0.2, 1),
                              move(20, 30, 0.2, 2.5), move(0, 0, 0.2, 2.5, Role::travel),
                              move(0, 0, 0.4, 2.5, Role::travel), move(8, 0, 0.4, 3)});
    ASSERT_EQ(layers.size(), 2U);
    EXPECT_NEAR(volume(layers), 3 * filament, 1e-9);
    EXPECT_NEAR(layers[0].z, 0.2, 1e-12);
    EXPECT_NEAR(layers[1].z, 0.4, 1e-12);
    for (const LaidLayer& layer : layers)
        for (const Path& path : layer.paths) EXPECT_NE(path.role, Role::travel);
}

// Thin and thick, also thinner than a disc of the layer's height.
TEST(LaidLayers, KnowBeadsByTheirSection) {
    for (const double section : {0.005, 0.03, 0.06, 0.2}) {
        const auto layers =
            laid({move(0, 0, 0.2, 0, Role::travel), move(10, 0, 0.2, 10 * section / filament)});
        EXPECT_NEAR(volume(layers), 10 * section, 1e-9) << section;
    }
}

TEST(LaidLayers, RetractionLaysNothing) {
    const auto layers =
        laid({move(0, 0, 0.2, 0, Role::travel), move(10, 0, 0.2, 1), move(10, 0, 0.2, 0.2),
              move(50, 50, 0.2, 0.2, Role::travel), move(50, 50, 0.2, 1), move(60, 50, 0.2, 2)});
    EXPECT_NEAR(volume(layers), 2 * filament, 1e-9);
    double way = 0;
    for (const Path& path : layers.at(0).paths) way += length(path);
    EXPECT_NEAR(way, 20, 1e-9);
}

TEST(LaidLayers, HeightIsWhatTheFileSays) {
    std::vector<Command> commands{
        {LayerStart{0.3, 0.3}}, move(0, 0, 0.3, 0, Role::travel), move(10, 0, 0.3, 1)};
    EXPECT_NEAR(laid(commands).at(0).height, 0.3, 1e-12);
    EXPECT_NEAR(laid(commands).at(0).paths.at(0).bead.height, 0.3, 1e-12);
    commands.erase(commands.begin());
    // Else what lies between it and the layer below.
    EXPECT_NEAR(laid(commands, 0.25).at(0).height, 0.3, 1e-12);
}

TEST(LaidLayers, SettingThePlaceMovesNothing) {
    SetPosition zero;
    zero.to[axis_e] = 0;
    const auto layers =
        laid({move(0, 0, 0.2, 0, Role::travel), move(10, 0, 0.2, 1), {zero}, move(20, 0, 0.2, 1)});
    EXPECT_NEAR(volume(layers), 2 * filament, 1e-9);
}

TEST(LaidLayers, ArcsBecomeChords) {
    Arc arc;
    arc.end.to = {0, 10, 0.2, 1};
    arc.end.role = Role::infill;
    arc.centre = {0, 0};
    const auto layers = laid({move(10, 0, 0.2, 0, Role::travel), {arc}});
    EXPECT_NEAR(volume(layers), filament, 1e-6);
    for (const Path& path : layers.at(0).paths)
        for (const Vec3& p : path.points) EXPECT_NEAR(length(flat(p)), 10, 1e-6);
}

TEST(LaidLayers, OfNothingAreNone) { EXPECT_TRUE(laid({}).empty()); }

}  // namespace
}  // namespace bead
