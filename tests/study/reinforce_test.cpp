#include "study/reinforce.h"

#include <gtest/gtest.h>

#include "geom/clip.h"
#include "infill/clear_of_walls.h"
#include "study/cases.h"
#include "study/reinforced_print.h"
#include "study/slicer_layouts.h"

namespace bead {
namespace {

LoadCase small_beam() {
    LoadCase part = beam_case({40, 12});
    part.guided = true;
    return part;
}

ReinforceOptions quick() {
    ReinforceOptions how;
    how.slicer_patterns = false;
    how.pixel = 0.2;
    how.threads = 1;
    return how;
}

TEST(Reinforced, WeighsWhatTheCaseSaysAndHolds) {
    const LoadCase part = small_beam();
    const auto found = reinforced(part, quick());
    ASSERT_TRUE(found);
    const Candidate& best = found->best();
    EXPECT_NEAR(deposited_area(best.layout, 0.6), asked_area(part), 0.006 * asked_area(part));
    EXPECT_TRUE(best.strength.holds);
    EXPECT_GT(found->stiffness_bound, best.strength.stiffness);
    const Region inside = offset(part.part, -0.3 + 0.01);
    for (const LayoutLine& line : best.layout)
        EXPECT_TRUE(outside_parts({line.points}, inside).empty());
}

TEST(Reinforced, HasNoFreeLineAlongAWall) {
    const LoadCase part = small_beam();
    const auto found = reinforced(part, quick());
    ASSERT_TRUE(found);
    std::vector<Polyline> walls;
    std::vector<FamilyLine> lines;
    for (const LayoutLine& line : found->best().layout) {
        if (line.kind == LineKind::wall) walls.push_back(line.points);
        if (line.kind == LineKind::tensile || line.kind == LineKind::compressive)
            lines.push_back({0, line.points});
    }
    double whole = 0;
    for (const FamilyLine& line : lines) whole += length(line.points);
    EXPECT_LT(length_along_walls(lines, walls, {}), 0.03 * whole);
}

TEST(Reinforced, IsTheSameForAnyNumberOfThreads) {
    ReinforceOptions how = quick();
    how.seeds = 2;
    const LoadCase part = cantilever_case({24, 10});
    const auto one = reinforced(part, how);
    how.threads = 2;
    const auto two = reinforced(part, how);
    ASSERT_TRUE(one && two);
    ASSERT_EQ(one->best().layout.size(), two->best().layout.size());
    for (std::size_t i = 0; i < one->best().layout.size(); ++i)
        EXPECT_EQ(one->best().layout[i].points, two->best().layout[i].points);
}

TEST(Reinforced, IsNoneWhereWallsTakeAll) {
    LoadCase part = small_beam();
    part.print.fill = 0.2;
    EXPECT_LT(asked_area(part), least_area(part));
    EXPECT_FALSE(reinforced(part, quick()));
}

TEST(SlicerLayouts, WeighTheSame) {
    const LoadCase part = small_beam();
    int found = 0;
    for (const SlicerSetting& setting : slicer_settings(1))
        if (const auto layout = slicer_layout(part, setting)) {
            ++found;
            EXPECT_NEAR(deposited_area(*layout, 0.6), asked_area(part), 0.005 * asked_area(part))
                << name_of(setting);
        }
    EXPECT_GE(found, 4);
}

// Tension first, then compression; the next layer the other way round; walls last.
TEST(ReinforcedPrint, HasItsOrder) {
    const LoadCase part = small_beam();
    const Layout layout{{LineKind::wall, {{1, 1}, {39, 1}}},
                        {LineKind::compressive, {{5, 2}, {5, 10}}},
                        {LineKind::tensile, {{2, 5}, {38, 5}}}};
    PlanOptions options;
    options.skirt_loops = 0;
    const std::vector<Toolpath> layers = toolpaths({layout, part, 2, {}}, options, {0, 0});
    ASSERT_EQ(layers.size(), 2U);
    std::vector<bool> level;  // of printed paths
    for (const Toolpath& layer : layers)
        for (const Path& path : layer)
            if (path.role != Role::travel)
                level.push_back(std::abs(path.points.front().y - path.points.back().y) < 1e-9);
    EXPECT_EQ(level, (std::vector<bool>{true, false, true, false, true, true}));
}

}  // namespace
}  // namespace bead
