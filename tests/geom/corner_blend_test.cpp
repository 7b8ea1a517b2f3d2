#include "geom/corner_blend.h"

#include <gtest/gtest.h>

#include "geom/deviation.h"
#include "support/regions.h"

namespace bead {
namespace {

// turn in °, then leg, peak curvature and length saved for a deviation of 1 mm, each of the arc
// and of the quintic.
struct Row {
    double turn, arc_leg, arc_curvature, arc_saved, leg, curvature, saved;
};
constexpr Row table[] = {{30, 7.60, 0.035, 0.349, 8.83, 0.036, 0.351},
                         {60, 3.73, 0.155, 0.695, 4.34, 0.160, 0.701},
                         {90, 2.41, 0.414, 1.036, 2.79, 0.430, 1.045},
                         {120, 1.73, 1.000, 1.370, 1.95, 1.047, 1.378},
                         {150, 1.30, 2.864, 1.692, 1.43, 3.056, 1.701}};

Polyline points_of(const CornerBlend& blend, int count = 400) {
    Polyline line;
    for (int i = 0; i <= count; ++i)
        line.push_back(point_at(blend, static_cast<double>(i) / count));
    return line;
}

TEST(CornerBlend, costs_and_saves_what_the_table_says) {
    for (const Row& row : table) {
        const Vec2 after = unit(row.turn * pi / 180);
        const auto blend = corner_blend({-1, 0}, {}, after, {.deviation = 1});
        ASSERT_TRUE(blend);
        EXPECT_NEAR(blend->leg / row.leg, 1, 0.01) << row.turn;
        EXPECT_NEAR(peak_curvature(*blend) / row.curvature, 1, 0.015) << row.turn;
        EXPECT_NEAR(2 * blend->leg - length(*blend), row.saved, 0.002) << row.turn;
        EXPECT_NEAR(blend->deviation, 1, 1e-12);

        const auto arc = arc_blend({-1, 0}, {}, after, {.deviation = 1});
        ASSERT_TRUE(arc);
        EXPECT_NEAR(arc->leg, row.arc_leg, 0.006) << row.turn;
        EXPECT_NEAR(1 / arc->arc.radius, row.arc_curvature, 0.0006) << row.turn;
        EXPECT_NEAR(2 * arc->leg - length(arc->arc), row.arc_saved, 0.001) << row.turn;
    }
}

TEST(CornerBlend, a_thousand_corners_keep_their_tolerance_and_join_straight_lines_smoothly) {
    test::RandomRegions random(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 corner = random.point(100);
        const double heading = random.uniform(0, 7), turn = random.uniform(-178, 178) * pi / 180;
        const Vec2 before = corner - random.uniform(0.5, 30) * unit(heading);
        const Vec2 after = corner + random.uniform(0.5, 30) * unit(heading + turn);
        const BlendOptions options{random.uniform(0.01, 1.5), random.uniform(0.05, 10)};
        const auto blend = corner_blend(before, corner, after, options);
        ASSERT_TRUE(blend);
        EXPECT_LE(blend->leg, options.longest_leg);
        const Polyline path{corner - blend->leg * unit(heading), corner,
                            corner + blend->leg * unit(heading + turn)};
        const Polyline smooth = points_of(*blend);
        EXPECT_NEAR(line_distance(smooth, corner), blend->deviation, 2e-4 * blend->leg);
        EXPECT_LE(deviation(path, smooth, 0.05), options.deviation + 2e-4 * blend->leg);
        EXPECT_LE(deviation(smooth, path, 0.05), options.deviation + 1e-9);
        const Nurbs curve = nurbs_of(*blend);
        for (const double end : {0.0, 1.0})
            EXPECT_NEAR(curvature(curve_at(curve, end)) * blend->leg, 0, 1e-9);
        EXPECT_LT(distance(smooth.front(), path.front()), 1e-12);
        EXPECT_LT(distance(smooth.back(), path.back()), 1e-12);
    }
}

TEST(CornerBlend, bends_one_way_and_nowhere_more_than_it_says) {
    for (int turn = 1; turn < 179; ++turn) {
        const auto blend = corner_blend({-1, 0}, {}, unit(turn * pi / 180), {.deviation = 0.1});
        ASSERT_TRUE(blend);
        const Nurbs curve = nurbs_of(*blend);
        const double peak = peak_curvature(*blend);
        EXPECT_NEAR(peak / peak_curvature(curve, 1000), 1, 1e-4) << turn;
        for (int i = 0; i <= 100; ++i)
            EXPECT_GT(curvature(curve_at(curve, i / 100.0)), -1e-7 * peak) << turn;
    }
}

// Other places of the control points on the same legs with the same deviation bend more, or less
// by at most 1 %.
TEST(CornerBlend, bends_as_little_as_such_a_curve_can) {
    for (int turn = 5; turn < 175; turn += 10) {
        const Vec2 in{1, 0}, out = unit(turn * pi / 180);
        const double peak = peak_curvature(*corner_blend({-1, 0}, {}, out, {.deviation = 1}));
        for (double k = 0.02; k < 0.48; k += 0.005) {
            const double leg = 16 / ((16 - 25 * k) * std::sin(turn * pi / 360));
            CornerBlend other{{}, leg, 1};
            for (std::size_t i = 0; i < 3; ++i) {
                other.points[i] = -leg * (1 - static_cast<double>(i) * k) * in;
                other.points[5 - i] = leg * (1 - static_cast<double>(i) * k) * out;
            }
            EXPECT_GT(peak_curvature(other), 0.99 * peak) << turn << "° " << k;
        }
    }
}

TEST(CornerBlend, arcs_begin_and_end_on_the_legs) {
    for (const double turn : {-2.0, -0.3, 0.5, 2.5}) {
        const auto blend =
            arc_blend({3, 1}, {5, 1}, Vec2{5, 1} + 2 * unit(turn), {.deviation = 0.2});
        ASSERT_TRUE(blend);
        EXPECT_LT(distance(point_at(blend->arc, 0), Vec2{5 - blend->leg, 1}), 1e-12);
        EXPECT_LT(distance(point_at(blend->arc, 1), Vec2{5, 1} + blend->leg * unit(turn)), 1e-12);
        EXPECT_NEAR(distance(point_at(blend->arc, 0.5), {5, 1}), 0.2, 1e-12);
    }
}

TEST(CornerBlend, there_is_none_without_a_corner) {
    EXPECT_FALSE(corner_blend({0, 0}, {1, 0}, {2, 0}, {}));
    EXPECT_FALSE(corner_blend({0, 0}, {1, 0}, {0, 0}, {}));
    EXPECT_FALSE(corner_blend({0, 0}, {0, 0}, {2, 0}, {}));
    EXPECT_FALSE(arc_blend({0, 0}, {1, 0}, {2, 0}, {}));
}

}  // namespace
}  // namespace bead
