#include "geom/arc.h"

#include <gtest/gtest.h>

#include "geom/deviation.h"
#include "support/regions.h"

namespace bead {
namespace {

TEST(Arc, chords_of_a_regular_polygon_have_the_sagitta_of_its_side) {
    for (const int corners : {5, 24, 75, 1000}) {
        Polyline line = test::regular({171, 112}, 17, corners);
        line.push_back(line.front());
        const double expected = 17 * (1 - std::cos(pi / corners));
        EXPECT_NEAR(mean_chord_sagitta(line), expected, 1e-9 * expected + 1e-13) << corners;
    }
}

TEST(Arc, points_on_a_line_have_no_sagitta) {
    EXPECT_EQ(mean_chord_sagitta({{0, 0}, {1, 1}, {2, 2}, {7, 7}}), 0);
    EXPECT_TRUE(std::isinf(circumradius({0, 0}, {1, 1}, {5, 5})));
    EXPECT_TRUE(std::isinf(circumradius({0, 0}, {1, 1}, {1, 1})));
}

TEST(Arc, a_corner_between_long_lines_looks_bad_by_its_sagitta) {
    EXPECT_NEAR(mean_chord_sagitta({{0, 0}, {20, 0}, {20, 20}}), 10 * std::sqrt(2) - 10, 1e-12);
}

TEST(Deviation, of_a_polygon_from_its_circle_is_its_sagitta) {
    Polyline gon = test::regular({}, 4, 24), circle = test::regular({}, 4, 2400);
    gon.push_back(gon.front());
    circle.push_back(circle.front());
    EXPECT_NEAR(deviation(gon, circle, 0.01), 4 * (1 - std::cos(pi / 24)), 1e-5);
    EXPECT_NEAR(deviation(circle, gon, 0.01), 4 * (1 - std::cos(pi / 24)), 1e-5);
}

TEST(Deviation, has_one_side) {
    const Polyline part{{0, 0}, {1, 0}}, whole{{0, 0}, {10, 0}};
    EXPECT_NEAR(deviation(part, whole), 0, 1e-15);
    EXPECT_EQ(deviation(whole, part), 9);
    EXPECT_EQ(line_distance(whole, {5, 3}), 3);
    EXPECT_EQ(line_distance({{1, 1}}, {4, 5}), 5);
}

}  // namespace
}  // namespace bead
