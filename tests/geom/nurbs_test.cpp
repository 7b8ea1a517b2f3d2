#include "geom/nurbs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/deviation.h"
#include "support/curves.h"

namespace bead {
namespace {

using test::RandomRegions;

TEST(Nurbs, a_rational_quadratic_is_a_quarter_circle) {
    const double root = std::sqrt(0.5);
    const Nurbs quarter{2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, root, 1}};
    for (int i = 0; i <= 100; ++i) {
        const CurvePlace place = curve_at(quarter, i / 100.0);
        EXPECT_NEAR(length(place.point), 1, 1e-15);
        EXPECT_NEAR(curvature(place), 1, 1e-13);
    }
    EXPECT_EQ(curve_at(quarter, 1).point, (Vec2{0, 1}));
}

TEST(Nurbs, a_bezier_curve_is_what_de_casteljau_says) {
    const Nurbs curve = bezier({{0, 0}, {1, 2}, {3, 3}, {4, 0}});
    EXPECT_LT(distance(curve_at(curve, 0.5).point, {2, 1.875}), 1e-15);
    EXPECT_LT(distance(curve_at(curve, 0).first, {3, 6}), 1e-14);
    EXPECT_LT(distance(curve_at(curve, 1).first, {3, -9}), 1e-14);
    EXPECT_LT(distance(curve_at(curve, 0).second, {6, -6}), 1e-13);
}

TEST(Nurbs, a_curve_of_degree_one_is_the_polygon) {
    const Nurbs line{1, {0, 0, 1, 2, 2}, {{0, 0}, {4, 0}, {4, 2}}, {1, 1, 1}};
    EXPECT_EQ(curve_at(line, 0.5).point, (Vec2{2, 0}));
    EXPECT_EQ(curve_at(line, 1.5).point, (Vec2{4, 1}));
    EXPECT_EQ(curve_at(line, 9).point, (Vec2{4, 2}));
    EXPECT_EQ(curve_at(line, 1.5).first, (Vec2{0, 2}));
}

RC_GTEST_PROP(Nurbs, arcs_are_exact, (unsigned seed)) {
    RandomRegions random(seed);
    const PlanarArc arc{random.point(100), random.uniform(0.1, 100), random.uniform(-7, 7),
                        random.uniform(-2 * pi, 2 * pi)};
    RC_PRE(std::abs(arc.sweep) > 1e-3);
    const Nurbs curve = nurbs_of(arc);
    RC_ASSERT(is_curve(curve));
    for (int i = 0; i <= 50; ++i) {
        const CurvePlace place = curve_at(curve, i / 50.0);
        RC_ASSERT(std::abs(distance(place.point, arc.centre) / arc.radius - 1) < 1e-12);
        const double bend = curvature(place) * arc.radius * (arc.sweep > 0 ? 1 : -1);
        RC_ASSERT(std::abs(bend - 1) < 1e-9);
    }
    RC_ASSERT(distance(curve_at(curve, 0).point, point_at(arc, 0)) < 1e-12);
    RC_ASSERT(distance(curve_at(curve, 1).point, point_at(arc, 1)) < 1e-12);
}

RC_GTEST_PROP(Nurbs, derivatives_are_those_of_differences, (unsigned seed)) {
    RandomRegions random(seed);
    const Nurbs curve = test::wild_cubic(random);
    RC_ASSERT(is_curve(curve));
    const double h = 1e-4, u = random.uniform(0.01, last_parameter(curve) - 0.01);
    for (const double knot : curve.knots) RC_PRE(std::abs(u - knot) > 2 * h);
    const CurvePlace place = curve_at(curve, u);
    const CurvePlace before = curve_at(curve, u - h), after = curve_at(curve, u + h);
    RC_ASSERT(length(place.first - (after.point - before.point) / (2 * h)) < 1e-3);
    RC_ASSERT(length(place.second - (after.first - before.first) / (2 * h)) < 1e-2);
}

// The convex hull of each span's control points holds it; moving control points moves the curve.
RC_GTEST_PROP(Nurbs, follow_their_control_points, (unsigned seed)) {
    RandomRegions random(seed);
    Nurbs curve = test::wild_cubic(random);
    const double u = random.uniform(0, last_parameter(curve)), angle = random.uniform(0, 7);
    const Vec2 shift = random.point(40), p = curve_at(curve, u).point;
    Box2 box = bounds(curve.points);
    RC_ASSERT(p.x >= box.low.x - 1e-9);
    RC_ASSERT(p.x <= box.high.x + 1e-9);
    curve.points = moved(curve.points, angle, {}, shift);
    RC_ASSERT(distance(curve_at(curve, u).point, moved({p}, angle, {}, shift)[0]) < 1e-10);
    RC_ASSERT(distance(curve_at(curve, 0).point, curve.points.front()) < 1e-12);
    RC_ASSERT(distance(curve_at(curve, 1e9).point, curve.points.back()) < 1e-12);
}

RC_GTEST_PROP(Nurbs, flattening_keeps_its_tolerance, (unsigned seed)) {
    RandomRegions random(seed);
    const Nurbs curve = test::wild_cubic(random);
    RC_PRE(peak_curvature(curve, 2000) < 1 / 0.01);
    const Polyline coarse = flattened(curve, 0.01), fine = flattened(curve, 1e-3);
    RC_ASSERT(coarse.size() < fine.size());
    RC_ASSERT(deviation(fine, coarse, 1) < 0.0111);
}

TEST(Nurbs, curves_that_make_no_sense_are_told) {
    Nurbs curve = bezier({{0, 0}, {1, 0}, {1, 1}});
    EXPECT_TRUE(is_curve(curve));
    curve.weights[1] = 0;
    EXPECT_FALSE(is_curve(curve));
    curve.weights[1] = 1;
    std::swap(curve.knots[1], curve.knots[4]);
    EXPECT_FALSE(is_curve(curve));
}

}  // namespace
}  // namespace bead
