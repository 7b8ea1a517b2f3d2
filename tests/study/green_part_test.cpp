#include "study/green_part.h"

#include <gtest/gtest.h>

#include "geom/polygon.h"
#include "study/cases.h"

namespace bead {
namespace {

LoadCase steel_case() {
    LoadCase steel = cantilever_case({30, 12});
    steel.material.green_plane = 1.2;
    steel.material.green_height = 1.25;
    steel.print = as_sintered(steel.print, steel.material);
    return steel;
}

// What the printer lays is what the case says, and the part is larger by the factors.
TEST(GreenPart, IsLargerAndHasThePrintersBeads) {
    const LoadCase steel = steel_case();
    EXPECT_NEAR(steel.print.bead_width, 0.5, 1e-12);
    EXPECT_NEAR(steel.print.layer_height, 0.48, 1e-12);
    const GreenPart green = green_part({{LineKind::wall, {{1, 2}, {3, 4}}}}, steel);
    EXPECT_NEAR(green.load_case.print.bead_width, 0.6, 1e-12);
    EXPECT_NEAR(green.load_case.print.layer_height, 0.6, 1e-12);
    EXPECT_NEAR(green.load_case.thickness, 7.5, 1e-12);
    EXPECT_NEAR(area(green.load_case.part), 1.44 * 360, 1e-9);
    EXPECT_NEAR(green.layout[0].points[1].y, 4.8, 1e-12);
}

// Printed and sintered, it is the layer that was tested.
TEST(GreenPart, ShrinksToWhatWasDesigned) {
    const LoadCase steel = steel_case();
    const Layout layout{{LineKind::tensile, {{1, 2}, {3, 4}, {8, 4}}}};
    const Toolpath wanted = layer_of(layout, steel.print);
    const GreenPart green = green_part(layout, steel);
    const Toolpath sintered =
        as_sintered(layer_of(green.layout, green.load_case.print), steel.material);
    ASSERT_EQ(sintered.size(), wanted.size());
    EXPECT_NEAR(sintered[0].bead.width, wanted[0].bead.width, 1e-12);
    EXPECT_NEAR(sintered[0].bead.height, wanted[0].bead.height, 1e-12);
    EXPECT_NEAR(volume(sintered[0]), volume(wanted[0]), 1e-12);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(length(sintered[0].points[i] - wanted[0].points[i]), 0, 1e-12);
}

TEST(GreenPart, OfPlasticIsThePart) {
    const LoadCase plastic = cantilever_case({30, 12});
    const GreenPart green = green_part({}, plastic);
    EXPECT_EQ(green.load_case.part, plastic.part);
    EXPECT_EQ(as_sintered(plastic.print, plastic.material).bead_width, plastic.print.bead_width);
}

}  // namespace
}  // namespace bead
