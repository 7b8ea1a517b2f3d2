// Braces and patches, and the loop that lays them, on a small frame: two chords and posts, as a
// ladder, which folds like one.
#include "study/strengthen.h"

#include <gtest/gtest.h>

#include "geom/clip.h"
#include "study/braces.h"
#include "study/cases.h"
#include "study/fixed_lines.h"
#include "study/patches.h"

namespace bead {
namespace {

constexpr Vec2 beam_size{36, 10};
constexpr double pixel = 0.2;

LoadCase ladder_case() {
    LoadCase part = cantilever_case(beam_size, {-20, -4});
    part.guided = true;
    return part;
}

Layout ladder(const LoadCase& part) {
    Layout lines = wall_lines(part.part, 0.6, 1);
    for (LayoutLine& pad : pad_lines(part, 1)) lines.push_back(std::move(pad));
    for (double x = 6; x < beam_size.x - 3; x += 6)
        lines.push_back({LineKind::compressive, {{x, 0.3}, {x, beam_size.y - 0.3}}});
    return lines;
}

TestRig rig_of(const LoadCase& part, const Layout& layout) {
    const Toolpath layer = layer_of(layout, part.print);
    return TestRig::of({&layer, 1}, part, {.pixel = pixel}).value();
}

double buckling_factor(const LoadCase& part, const Layout& layout) {
    const TestRig rig = rig_of(part, layout);
    return rig.modes(0, rig.tested(0).displacement, {.count = 1}).front().factor;
}

Layout together(Layout lines, const Layout& more) {
    lines.insert(lines.end(), more.begin(), more.end());
    return lines;
}

TEST(Braces, LiftTheBucklingLoadAndKeepTheirBounds) {
    const LoadCase part = ladder_case();
    const Layout lines = ladder(part);
    const TestRig rig = rig_of(part, lines);
    const VariantModes modes{0, rig.modes(0, rig.tested(0).displacement, {.count = 4})};
    const BraceOptions how{.area = 25, .shortest = 3};
    const Layout found = braces(rig, part, {modes}, how);
    ASSERT_FALSE(found.empty());
    EXPECT_LE(found.size(), std::size_t(how.most));
    EXPECT_LT(deposited_area(found, 0.6), how.area + 6 * 0.6);
    const Region inside = offset(part.part, -0.3 + 0.01);
    for (const LayoutLine& brace : found) {
        EXPECT_EQ(brace.kind, LineKind::brace);
        EXPECT_GE(length(brace.points), how.shortest - 1e-9);
        EXPECT_LE(length(brace.points), how.longest + 1);
        EXPECT_TRUE(outside_parts({brace.points}, inside).empty());
    }
    EXPECT_GT(buckling_factor(part, together(lines, found)), 1.3 * buckling_factor(part, lines));
}

TEST(Braces, NoModesNoBraces) {
    const LoadCase part = ladder_case();
    EXPECT_TRUE(braces(rig_of(part, ladder(part)), part, {{0, {}}}, {}).empty());
}

TEST(Patches, LowerTheStressThatTheyAreFor) {
    LoadCase part = cantilever_case(beam_size, {0, -5});
    part.guided = true;
    const Layout lines = ladder(part);
    const TestRig rig = rig_of(part, lines);
    const std::vector<Tested> before{rig.tested(0)};
    const std::vector<PixelVector> adjoint = sensitivity(rig, before);
    const Layout found = patches(lines, rig, before, adjoint, part, {.area = 15, .most_area = 20});
    ASSERT_FALSE(found.empty());
    const Region inside = offset(part.part, -0.3 + 0.01);
    for (const LayoutLine& patch : found) {
        EXPECT_EQ(patch.kind, LineKind::patch);
        EXPECT_GT(length(patch.points), 1.5);
        EXPECT_TRUE(outside_parts({patch.points}, inside).empty());
    }
    const TestRig stronger = rig_of(part, together(lines, found));
    EXPECT_LT(failure_norm(std::vector<Tested>{stronger.tested(0)}), 0.95 * failure_norm(before));
    // The best one is left out when asked.
    const Layout others = patches(lines, rig, before, adjoint, part,
                                  {.area = 15, .most_area = 20, .most = 1, .skipped = 1});
    ASSERT_EQ(others.size(), 1U);
    EXPECT_NE(others.front().points, found.front().points);
}

TEST(Strengthened, SpendsTheRestAndIsNoWeaker) {
    const LoadCase part = ladder_case();
    const Layout lines = ladder(part);
    const double before = deposited_area(lines, 0.6);
    const Strengthened strong =
        strengthened(part, lines, {.area = 1.12 * before, .pixel = pixel, .modes = 4});
    ASSERT_GT(strong.steps.size(), 1U);
    // The last brace may be longer than what is left, by 6 mm.
    EXPECT_LE(deposited_area(strong.layout, 0.6), 1.12 * before + 6 * 0.6);
    EXPECT_GT(deposited_area(strong.layout, 0.6), 1.02 * before);
    const auto bears = [](const StrengthenStep& s) {
        return std::min(s.failure_factor, s.buckling_factor);
    };
    EXPECT_GT(bears(strong.steps.back()), 1.2 * bears(strong.steps.front()));
    double area = 0;
    for (const StrengthenStep& step : strong.steps) {
        EXPECT_GE(step.area, area);
        area = step.area;
    }
    // What was laid first is still there, in its order.
    for (std::size_t i = 0; i < lines.size(); ++i)
        EXPECT_EQ(strong.layout[i].points, lines[i].points);
}

TEST(Strengthened, LeavesWhatIsFullAsItIs) {
    const LoadCase part = ladder_case();
    const Layout lines = ladder(part);
    const Strengthened same =
        strengthened(part, lines, {.area = deposited_area(lines, 0.6), .pixel = pixel});
    EXPECT_EQ(same.layout.size(), lines.size());
}

TEST(Strengthened, DoesNotMendWhatDoesNotHangTogether) {
    const LoadCase part = cantilever_case(beam_size);
    const Layout lines{{LineKind::tensile, {{1, 5}, {5, 5}}},
                       {LineKind::tensile, {{20, 5}, {30, 5}}}};
    const Strengthened same = strengthened(part, lines, {.area = 100, .pixel = pixel});
    EXPECT_EQ(same.layout.size(), 2U);
    EXPECT_TRUE(same.steps.empty());
}

}  // namespace
}  // namespace bead
