#include "study/bed_place.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "geom/polygon.h"
#include "study/cases.h"
#include "study/fixed_lines.h"
#include "study/part_beads.h"
#include "study/slicer_layouts.h"

namespace bead {
namespace {

// An L with a hole: no turn and no mirroring leaves it alike.
LoadCase bracket() {
    LoadCase result = cantilever_case({40, 12});
    result.part = {{{{0, 0}, {40, 0}, {40, 15}, {12, 15}, {12, 30}, {0, 30}},
                    {{{30, 5}, {30, 9}, {34, 9}, {34, 5}}}}};
    result.situations[0].loads[0] = pull({40, 0}, {40, 15}, {0, -1});
    return result;
}

std::vector<Toolpath> sliced(const LoadCase& load_case) {
    const auto layout = slicer_layout(load_case, {SlicerPattern::triangles, 1, 0, 1});
    return {layer_of(*layout, load_case.print)};
}

std::vector<Toolpath> on_bed(std::vector<Toolpath> layers, const BedPlace& place) {
    for (Toolpath& layer : layers)
        for (Path& path : layer)
            for (Vec3& p : path.points) {
                const Vec2 flipped = place.mirrored ? Vec2{-p.x, p.y} : flat(p);
                p = at_height(rotated(flipped, unit(place.turn)) + place.origin, p.z);
            }
    return layers;
}

double farthest(const std::vector<Toolpath>& a, const std::vector<Toolpath>& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        for (std::size_t i = 0; i < a[k].size(); ++i)
            for (std::size_t j = 0; j < a[k][i].points.size(); ++j)
                most = std::max(most, length(a[k][i].points[j] - b[k][i].points[j]));
    return most;
}

TEST(BedPlace, IsFoundWhereverAPartStands) {
    const LoadCase load_case = bracket();
    const std::vector<Toolpath> laid = sliced(load_case);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(0, 2 * pi), place(-200, 200);
    for (int trial = 0; trial < 12; ++trial) {
        const double turn = trial < 4 ? trial * pi / 2 : angle(random);
        const BedPlace there{turn, trial % 3 == 2, {place(random), place(random)}};
        const auto found = bed_place(on_bed(laid, there), load_case.part);
        ASSERT_TRUE(found) << trial;
        EXPECT_EQ(found->mirrored, there.mirrored) << trial;
        EXPECT_LT(farthest(in_case(*found, on_bed(laid, there)), laid), 0.6) << trial;
    }
}

TEST(BedPlace, OfWholeDegreesIsExact) {
    const LoadCase load_case = bracket();
    const std::vector<Toolpath> laid = sliced(load_case);
    const auto found = bed_place(on_bed(laid, {37 * pi / 180, false, {50, 60}}), load_case.part);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->turn, 37 * pi / 180, 1e-12);
    EXPECT_NEAR(distance(found->origin, {50, 60}), 0, 0.1);
}

TEST(BedPlace, IsNoneForAnotherPart) {
    LoadCase other = bracket();
    const std::vector<Toolpath> laid = sliced(other);
    other.part[0].outer[2] = {40, 19};
    other.part[0].outer[3] = {12, 19};
    EXPECT_FALSE(bed_place(laid, other.part));
    EXPECT_FALSE(bed_place(laid, box_part({40, 31.5})));
}

// A rib thinner than a bead is in the case, not in the print.
TEST(BedPlace, IsFoundWithoutWhatIsTooThinToPrint) {
    LoadCase load_case = bracket();
    const std::vector<Toolpath> laid = sliced(load_case);
    Polyline& outer = load_case.part[0].outer;
    for (const Vec2 p : {Vec2{6, 30}, Vec2{6, 36}, Vec2{5.7, 36}, Vec2{5.7, 30}})
        outer.insert(outer.end() - 1, p);
    EXPECT_TRUE(bed_place(laid, load_case.part));
}

TEST(BedPlace, IsAsTold) {
    const LoadCase load_case = cantilever_case({40, 12});
    const std::vector<Toolpath> laid = sliced(load_case);
    // A rectangle's half turn fits as well; only who turned it knows.
    const std::vector<Toolpath> turned = on_bed(laid, {pi, false, {100, 100}});
    EXPECT_EQ(bed_place(turned, load_case.part)->turn, 0);
    const auto told = bed_place(turned, load_case.part, {pi, Vec2{100, 100}});
    ASSERT_TRUE(told);
    EXPECT_LT(farthest(in_case(*told, turned), laid), 1e-9);
    EXPECT_FALSE(bed_place(turned, load_case.part, {pi / 2, {}}));
    EXPECT_FALSE(bed_place(turned, load_case.part, {pi, Vec2{80, 100}}));
}

Path line(Role role, std::vector<Vec3> points) { return {role, {0.6, 0.3}, 40, 0, false, points}; }

TEST(PartBeads, AreTheHeaviestThatHangTogether) {
    const LoadCase load_case = bracket();
    const std::vector<Toolpath> laid = sliced(load_case);
    std::vector<Toolpath> all = laid;
    // A skirt that nothing names, a line that primes, a small copy; and what is named.
    all[0].push_back(line(Role::other, {{-4, -4, 0}, {44, -4, 0}, {44, 34, 0}, {-4, 34, 0}}));
    all[0].push_back(line(Role::other, {{-40, -20, 0}, {60, -20, 0}}));
    all[0].push_back(line(Role::infill, {{80, 0, 0}, {85, 0, 0}}));
    all[0].push_back(line(Role::skirt, {{3, 3, 0}, {4, 3, 0}}));
    all.push_back({line(Role::travel, {{0, 0, 0}, {1, 1, 0}})});
    const PartBeads part = part_beads(all);
    ASSERT_EQ(part.layers.size(), 1U);
    EXPECT_EQ(part.layers[0].size(), laid[0].size());
    EXPECT_NEAR(part.left_out, (48 + 38 + 48 + 100 + 5) * section({0.6, 0.3}), 1e-9);
}

TEST(PartBeads, OfNothingAreNone) {
    EXPECT_TRUE(part_beads({}).layers.empty());
    EXPECT_TRUE(part_beads({{line(Role::support, {{0, 0, 0}, {9, 0, 0}})}}).layers.empty());
}

}  // namespace
}  // namespace bead
