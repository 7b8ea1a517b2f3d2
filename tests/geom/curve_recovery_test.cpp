#include "geom/curve_recovery.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/cubic_spline.h"
#include "geom/deviation.h"
#include "support/regions.h"

namespace bead {
namespace {

double radius_error(const Nurbs& curve, Vec2 centre, double radius) {
    double worst = 0;
    for (int i = 0; i <= 5000; ++i) {
        const double u = last_parameter(curve) * i / 5000;
        worst = std::max(worst, std::abs(distance(curve_at(curve, u).point, centre) - radius));
    }
    return worst;
}

TEST(CurveRecovery, finds_the_circles_of_bores) {
    const auto bolt = recovered_loop(test::regular({171, 112}, 4, 24), {});
    ASSERT_EQ(bolt.size(), 1U);
    ASSERT_TRUE(bolt[0].curve);
    EXPECT_LT(radius_error(*bolt[0].curve, {171, 112}, 4), 5e-5);
    const auto bore = recovered_loop(test::regular({171, 112}, 17, 75), {});
    ASSERT_TRUE(bore[0].curve);
    EXPECT_LT(radius_error(*bore[0].curve, {171, 112}, 17), 2.2e-6);
}

// Lines stay lines, half circles become curves that leave them without a corner.
TEST(CurveRecovery, finds_the_ends_of_a_slot) {
    Polyline slot;
    for (int i = 0; i <= 16; ++i) slot.push_back(Vec2{8, 0} + 1.75 * unit(-pi / 2 + pi * i / 16));
    for (int i = 0; i <= 16; ++i) slot.push_back(Vec2{-8, 0} + 1.75 * unit(pi / 2 + pi * i / 16));
    std::rotate(slot.begin(), slot.begin() + 5, slot.end());
    const auto runs = recovered_loop(slot, {});
    ASSERT_EQ(runs.size(), 4U);
    int curves = 0;
    for (const RecoveredRun& run : runs) {
        if (!run.curve) {
            EXPECT_EQ(run.points.size(), 2U);
            continue;
        }
        ++curves;
        const Vec2 centre{run.points[4].x > 0 ? 8.0 : -8.0, 0};
        EXPECT_LT(radius_error(*run.curve, centre, 1.75), 1.2e-4);
        EXPECT_NEAR(curve_at(*run.curve, 0).first.y, 0, 1e-12);
    }
    EXPECT_EQ(curves, 2);
}

TEST(CurveRecovery, keeps_corners) {
    const auto runs = recovered_loop({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {});
    ASSERT_EQ(runs.size(), 4U);
    for (const RecoveredRun& run : runs) EXPECT_FALSE(run.curve);
}

TEST(CurveRecovery, does_not_believe_what_leaves_the_polygon) {
    const Polyline bent{{0, 0}, {20, 0}, {39, 5}};
    ASSERT_EQ(recovered_runs(bent, {}).size(), 1U);
    EXPECT_FALSE(recovered_runs(bent, {})[0].curve);
    EXPECT_TRUE(recovered_runs(bent, {.tolerance = 2})[0].curve);
}

// Any line: runs follow each other, keep all points, and stay near.
RC_GTEST_PROP(CurveRecovery, keeps_points_and_tolerance, (unsigned seed)) {
    test::RandomRegions random(seed);
    Polyline line{{}};
    double heading = 0, bend = 0;
    for (int i = 0; i < 200; ++i) {
        if (random.whole(0, 9) == 0) bend = random.uniform(-0.4, 0.4);
        if (random.whole(0, 19) == 0) heading += random.uniform(-2, 2);
        heading += bend;
        line.push_back(line.back() + (random.whole(0, 9) == 0 ? 5.0 : 1.0) * unit(heading));
    }
    const RecoveryOptions options{.tolerance = random.uniform(0.01, 0.2)};
    std::size_t at = 0;
    for (const RecoveredRun& run : recovered_runs(line, options)) {
        for (const Vec2 p : run.points) RC_ASSERT(p == line[at++]);
        --at;
        if (!run.curve) continue;
        RC_ASSERT(is_curve(*run.curve));
        const Polyline smooth = flattened(*run.curve, 1e-3);
        for (const Vec2 p : run.points) RC_ASSERT(line_distance(smooth, p) < 2e-3);
        RC_ASSERT(deviation(smooth, run.points) < 1.1 * options.tolerance);
    }
    RC_ASSERT(at + 1 == line.size());
}

TEST(CubicSpline, is_smooth_to_the_second_derivative) {
    const Polyline points{{0, 0}, {1, 2}, {3, 2.5}, {4, 0}, {7, 1}};
    const Nurbs curve = cubic_through(points, {0, 1}, {1, 0});
    ASSERT_TRUE(is_curve(curve));
    for (std::size_t i = 4; i + 4 < curve.knots.size(); i += 2) {
        const CurvePlace before = curve_at(curve, curve.knots[i] - 1e-9);
        const CurvePlace after = curve_at(curve, curve.knots[i]);
        EXPECT_LT(distance(before.first, after.first), 1e-6);
        EXPECT_LT(distance(before.second, after.second), 1e-6);
        EXPECT_LT(distance(after.point, points[i / 2 - 1]), 1e-12);
    }
    EXPECT_LT(distance(curve_at(curve, 0).first, {0, 1}), 1e-12);
    EXPECT_LT(distance(curve_at(curve, 1e9).first, {1, 0}), 1e-12);
}

// Half the distance of the points, a sixteenth of the error.
TEST(CubicSpline, nears_a_circle_with_the_fourth_power) {
    double before = 0;
    for (int corners = 12; corners < 200; corners *= 2) {
        const double error =
            radius_error(closed_cubic_through(test::regular({}, 10, corners)), {}, 10);
        if (before > 0) {
            EXPECT_NEAR(before / error, 16, 1) << corners;
        }
        before = error;
    }
}

}  // namespace
}  // namespace bead
