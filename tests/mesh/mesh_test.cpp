#include "mesh/mesh.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/shapes.h"

namespace bead {
namespace {

TEST(mesh, volumes_are_those_of_geometry) {
    EXPECT_NEAR(volume(shapes::box({2, 3, 4})), 24, 1e-12);
    EXPECT_NEAR(volume(shapes::cylinder(5, 2, 64)), 2 * area(Polygon{shapes::regular(5, 64), {}}),
                1e-9);
    EXPECT_NEAR(volume(shapes::inside_out(shapes::box({2, 3, 4}))), -24, 1e-12);
}

// Facets cut off an error of second order in their size.
TEST(mesh, a_finer_sphere_nears_the_round_one_by_second_order) {
    const double round = 4.0 / 3 * pi * 1000;
    const double coarse = round - volume(shapes::sphere(10, 20));
    const double fine = round - volume(shapes::sphere(10, 40));
    EXPECT_NEAR(coarse / fine, 4, 0.1);
}

RC_GTEST_PROP(mesh, moving_keeps_the_volume, (std::uint64_t seed)) {
    const Mesh mesh = shapes::random_extrusion(seed, 5);
    const double angle = *rc::gen::inRange(0, 628) / 100.0;
    const Vec3 shift{*rc::gen::inRange(-500, 500) / 1.0, 17, -3};
    const Mesh elsewhere = moved(mesh, angle, shift);
    RC_ASSERT(std::abs(volume(elsewhere) / volume(mesh) - 1) < 1e-12);
    RC_ASSERT(bounds(elsewhere).low.z == bounds(mesh).low.z - 3);
}

}  // namespace
}  // namespace bead
