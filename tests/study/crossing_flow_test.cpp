#include "study/crossing_flow.h"

#include <gtest/gtest.h>

#include "geom/crossings.h"
#include "toolpath/path.h"

namespace bead {
namespace {

constexpr PrintWish half{.bead_width = 0.6, .layer_height = 0.3, .crossing_flow = 0.5};

// One crossing in the middle: 1.2 mm of 20 with half the plastic.
TEST(CrossingFlow, IsLessAWidthToEitherSide) {
    const Layout cross{{LineKind::tensile, {{10, -5}, {10, 5}}},
                       {LineKind::compressive, {{0, 0}, {20, 0}}}};
    EXPECT_NEAR(deposited_area(cross, half), 0.6 * (10 + 20 - 0.6), 1e-12);
    EXPECT_NEAR(deposited_area(cross, half, LineKind::tensile), 0.6 * 10, 1e-12);
    EXPECT_EQ(deposited_area(cross, PrintWish{}), deposited_area(cross, 0.6));
    const Toolpath layer = layer_of(cross, half);
    ASSERT_EQ(layer.size(), 4U);
    EXPECT_NEAR(layer[2].points.front().x, 9.4, 1e-12);
    EXPECT_NEAR(layer[2].points.back().x, 10.6, 1e-12);
    EXPECT_NEAR(section(layer[2].bead), 0.5 * section(layer[1].bead), 1e-12);
}

TEST(CrossingFlow, LeavesLinesWholeThatCrossNone) {
    const Polyline line{{0, 0}, {5, 1}, {9, 1}};
    const std::vector<FlowPart> parts = flow_parts(line, {}, 0.6, 0.5);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].points, line);
    EXPECT_EQ(parts[0].flow, 1);
}

// The parts are the line again, in its order and without gaps; none is a speck.
TEST(CrossingFlow, PartsGoOnWhereTheOneBeforeEnds) {
    const Polyline line{{0, 0}, {5, 1}, {9, 1}, {9, 7}};
    const std::vector<double> places{0.2, 3, 4.25, 4.3, 7, 8.29, length(line) - 0.65};
    const std::vector<FlowPart> parts = flow_parts(line, places, 0.6, 0.5);
    EXPECT_EQ(parts.front().points.front(), line.front());
    EXPECT_EQ(parts.back().points.back(), line.back());
    double sum = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        sum += length(parts[i].points);
        EXPECT_GE(length(parts[i].points), 0.1 - 1e-9);
        if (i == 0) continue;
        EXPECT_EQ(parts[i].points.front(), parts[i - 1].points.back());
        EXPECT_NE(parts[i].flow, parts[i - 1].flow);
    }
    EXPECT_NEAR(sum, length(line), 1e-9);
}

// Section for section, whatever the share.
TEST(CrossingFlow, HasItsShareOfTheSection) {
    for (const double height : {0.2, 0.45, 0.6})
        for (const double flow : {0.1, 0.35, 0.5, 0.8, 1.0}) {
            const PrintWish print{.bead_width = 0.6, .layer_height = height};
            EXPECT_NEAR(section(printed_bead(print, flow)), flow * 0.6 * height, 1e-12)
                << height << ' ' << flow;
        }
}

}  // namespace
}  // namespace bead
