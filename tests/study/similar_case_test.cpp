#include "study/similar_case.h"

#include <gtest/gtest.h>

#include "strength/usual_scale.h"
#include "study/cases.h"
#include "study/fixed_lines.h"
#include "study/slicer_layouts.h"

namespace bead {
namespace {

Strength tested(const LoadCase& load_case, const Layout& layout) {
    const Toolpath layer = layer_of(layout, load_case.print);
    return strength_of({&layer, 1}, load_case, {});
}

// A part twenty times as large, of beads twenty times as wide, bears 400 times the load.
TEST(SimilarCase, BearsByTheSquareOfItsScale) {
    const LoadCase small = cantilever_case({40, 12});
    const auto layout = slicer_layout(small, {SlicerPattern::triangles, 1, 0, 1});
    ASSERT_TRUE(layout);
    const LoadCase large = similar(small, 20);
    EXPECT_NEAR(usual_scale(large.print), 0.9 / 12, 1e-12);
    const Strength wanted = similar(tested(small, *layout), 20);
    const Strength found = tested(large, similar(*layout, 20));
    EXPECT_NEAR(found.mass, wanted.mass, 1e-9 * wanted.mass);
    EXPECT_NEAR(found.stiffness, wanted.stiffness, 1e-6 * wanted.stiffness);
    EXPECT_NEAR(found.buckling_load, wanted.buckling_load, 0.01 * wanted.buckling_load);
    // Averaged over 0.9 mm of a similar part there, over 0.6 mm here.
    EXPECT_NEAR(found.failure_load, wanted.failure_load, 0.2 * wanted.failure_load);
}

TEST(SimilarCase, OfOrdinaryBeadsIsTheCase) {
    for (const double width : {0.4, 0.6, 0.9}) EXPECT_EQ(usual_scale({.bead_width = width}), 1);
    EXPECT_NEAR(usual_scale({.bead_width = 0.2}), 2, 1e-12);
}

TEST(SimilarCase, ThereAndBackIsTheSame) {
    const LoadCase bar = cantilever_case({40, 12});
    const LoadCase back = similar(similar(bar, 8), 1.0 / 8);
    EXPECT_EQ(back.part, bar.part);
    EXPECT_EQ(back.thickness, bar.thickness);
    EXPECT_EQ(back.situations[0].loads[0].on.to, bar.situations[0].loads[0].on.to);
}

// Nothing of a part so small is 4 mm away from its ends.
TEST(Strength, OfASmallPartIsFinite) {
    const LoadCase small = cantilever_case({4, 3});
    const Strength s = tested(small, wall_lines(small.part, small.print.bead_width, 2));
    ASSERT_TRUE(s.holds);
    EXPECT_TRUE(std::isfinite(s.failure_load));
    EXPECT_GT(s.failure_load, 0);
}

}  // namespace
}  // namespace bead
