#include "geom/curve_fit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/deviation.h"
#include "support/curves.h"

namespace bead {
namespace {

TEST(CurveFit, finds_a_cubic_that_is_one) {
    const Nurbs cubic = bezier({{0, 0}, {10, 20}, {30, 20}, {40, 0}});
    Polyline points;
    for (int i = 0; i <= 100; ++i) points.push_back(curve_at(cubic, i / 100.0).point);
    const auto fit = fitted_curve(points, 0.02);
    ASSERT_TRUE(fit);
    EXPECT_LE(fit->curve.points.size(), 8U);
    EXPECT_LT(deviation(flattened(cubic, 1e-4), flattened(fit->curve, 1e-4)), 0.021);
}

TEST(CurveFit, calms_noise_that_is_below_the_tolerance) {
    test::RandomRegions random(3);
    Polyline points;
    for (int i = 0; i <= 300; ++i)
        points.push_back(20.0 * unit(pi * i / 300) + random.point(0.004));
    const auto fit = fitted_curve(points, 0.01);
    ASSERT_TRUE(fit);
    EXPECT_LT(fit->curve.points.size(), 20U);
    for (int i = 0; i <= 1000; ++i)
        EXPECT_NEAR(length(curve_at(fit->curve, i / 1000.0).point), 20, 0.008);
}

RC_GTEST_PROP(CurveFit, keeps_its_tolerance, (unsigned seed)) {
    test::RandomRegions random(seed);
    const Polyline points = flattened(test::wild_cubic(random), 0.01);
    const double tolerance = random.uniform(0.02, 0.5);
    const auto fit = fitted_curve(points, tolerance);
    if (!fit) return;
    RC_ASSERT(is_curve(fit->curve));
    RC_ASSERT(fit->curve.points.size() <= points.size());
    RC_ASSERT(curve_at(fit->curve, 0).point == points.front());
    RC_ASSERT(distance(curve_at(fit->curve, 1).point, points.back()) < 1e-12);
    const Polyline smooth = flattened(fit->curve, 1e-3);
    for (const Vec2 p : points) RC_ASSERT(line_distance(smooth, p) < tolerance + 2e-3);
}

}  // namespace
}  // namespace bead
