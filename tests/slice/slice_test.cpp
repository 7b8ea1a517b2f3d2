#include "slice/slice.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/clip.h"
#include "support/shapes.h"

namespace bead {
namespace {

SliceOptions exact(double height) {
    return {.layer_height = height, .first_layer_height = height, .resolution = 0};
}

double sliced_volume(const Slices& slices) {
    double sum = 0;
    for (const Layer& layer : slices.layers) sum += area(layer.region) * layer.height;
    return sum;
}

// Area that belongs to one region only.
double disagreement(const Region& a, const Region& b) {
    return area(difference(a, b)) + area(difference(b, a));
}

bool is_clean(const Region& region) {
    for (const Polygon& polygon : region) {
        if (signed_area(polygon.outer) <= 0) return false;
        for (const Polyline& hole : polygon.holes)
            if (signed_area(hole) >= 0) return false;
    }
    return true;
}

TEST(slice, layers_stack_up_until_their_middle_is_above_the_part) {
    const SliceOptions options{.layer_height = 0.2, .first_layer_height = 0.3};
    const Slices slices = slice(moved(shapes::box({5, 5, 1.19}), 0, {0, 0, 7}), options);
    ASSERT_EQ(slices.layers.size(), 5U);  // tops at 0.3 0.5 0.7 0.9 1.1; the next middle is at 1.2
    EXPECT_DOUBLE_EQ(slices.layers[0].z, 0.3);
    EXPECT_DOUBLE_EQ(slices.layers[0].height, 0.3);
    EXPECT_DOUBLE_EQ(slices.layers[4].z, 1.1);
    EXPECT_DOUBLE_EQ(slices.layers[4].height, 0.2);
    EXPECT_EQ(slice(shapes::box({5, 5, 1.21}), options).layers.size(), 6U);
    EXPECT_TRUE(slice(Mesh{}, options).layers.empty());
}

TEST(slice, a_prism_has_its_outline_in_every_layer) {
    const Polyline outline = shapes::regular(10, 48);
    for (const Layer& layer : slice(shapes::extruded(outline, 4), exact(0.2)).layers)
        EXPECT_LT(disagreement(layer.region, {{outline, {}}}), 1e-4);
}

TEST(slice, holes_run_clockwise_inside_their_outline) {
    const Slices slices = slice(shapes::plate_with_hole(40, 3, 8, 64), exact(0.2));
    ASSERT_EQ(slices.layers.size(), 15U);
    for (const Layer& layer : slices.layers) {
        ASSERT_EQ(layer.region.size(), 1U);
        ASSERT_EQ(layer.region[0].holes.size(), 1U);
        EXPECT_NEAR(signed_area(layer.region[0].outer), 1600, 1e-4);
        EXPECT_NEAR(signed_area(layer.region[0].holes[0]), -32 * 64 * std::sin(2 * pi / 64), 1e-4);
    }
}

// The midpoint rule errs by the square of the layer height, here by the closed form
// pi * diameter * height² / 12 of a round sphere.
TEST(slice, a_sphere_is_summed_to_second_order) {
    const Mesh ball = shapes::sphere(10, 300);
    const auto error = [&](double h) {
        return sliced_volume(slice(ball, exact(h))) - volume(ball);
    };
    for (const double h : {1.0, 0.5}) EXPECT_NEAR(error(h), pi * 20 * h * h / 12, 0.3);
}

TEST(slice, simplification_strays_by_no_more_than_the_resolution) {
    const Mesh mesh = shapes::cylinder(10, 1, 2000);
    const Region fine = slice(mesh, exact(0.5)).layers[0].region;
    const Region coarse =
        slice(mesh, {.layer_height = 0.5, .first_layer_height = 0.5, .resolution = 0.05})
            .layers[0]
            .region;
    EXPECT_LT(coarse[0].outer.size(), fine[0].outer.size() / 10);
    EXPECT_TRUE(difference(coarse, fine).empty());  // chords of a circle
    EXPECT_LT(disagreement(coarse, fine), 0.05 * perimeter(fine));
}

RC_GTEST_PROP(slice, turning_and_moving_the_part_turns_and_moves_its_layers, (std::uint64_t seed)) {
    const Mesh mesh = shapes::together(shapes::random_extrusion(seed, 2), shapes::sphere(6, 9));
    const double angle = *rc::gen::inRange(0, 628) / 100.0;
    const Vec3 shift{*rc::gen::inRange(-1000, 1000) / 7.0, *rc::gen::inRange(-1000, 1000) / 7.0,
                     *rc::gen::inRange(-1000, 1000) / 7.0};
    const Slices here = slice(mesh, exact(0.4));
    const Slices there = slice(moved(mesh, angle, shift), exact(0.4));
    RC_ASSERT(here.layers.size() == there.layers.size());
    for (std::size_t i = 0; i < here.layers.size(); ++i) {
        const Region expected = moved(here.layers[i].region, angle, {}, flat(shift));
        RC_ASSERT(disagreement(there.layers[i].region, expected) < 1e-3);
        RC_ASSERT(is_clean(there.layers[i].region));
    }
}

RC_GTEST_PROP(slice, shells_that_overlap_become_one, (std::uint64_t seed)) {
    const Mesh a = shapes::random_extrusion(seed, 1);
    const Mesh b = moved(shapes::random_extrusion(seed + 1, 1), 0, {9, 4, 0});
    const Region both = slice(shapes::together(a, b), exact(0.5)).layers[0].region;
    const Region expected =
        united(slice(a, exact(0.5)).layers[0].region, slice(b, exact(0.5)).layers[0].region);
    RC_ASSERT(disagreement(both, expected) < 1e-3);
}

TEST(slice, a_cavity_stays_empty_and_a_shell_inside_out_is_solid) {
    const Mesh cavity = moved(shapes::inside_out(shapes::box({4, 4, 4})), 0, {3, 3, 3});
    const Mesh hollow = shapes::together(shapes::box({10, 10, 10}), cavity);
    EXPECT_NEAR(sliced_volume(slice(hollow, exact(0.5))), 1000 - 64, 1e-3);
    const Mesh beside = moved(shapes::inside_out(shapes::box({4, 4, 4})), 0, {20, 0, 0});
    EXPECT_NEAR(sliced_volume(slice(shapes::together(hollow, beside), exact(0.5))), 1000, 1e-3);
    EXPECT_NEAR(sliced_volume(slice(shapes::inside_out(hollow), exact(0.5))), 1000 - 64, 1e-3);
}

RC_GTEST_PROP(slice, turned_triangles_do_not_matter, (std::uint64_t seed)) {
    Mesh mesh = shapes::plate_with_hole(40, 3, 8, 32);
    const double expected = volume(mesh);
    std::mt19937_64 random(seed);
    for (auto& triangle : mesh.triangles)
        if (random() % 4 == 0) std::swap(triangle[0], triangle[1]);
    RC_ASSERT(std::abs(sliced_volume(slice(mesh, exact(0.5))) - expected) < 1e-2);
}

// All that the wall of the hole has is turned: in a layer by itself it looks like an island.
TEST(slice, a_hole_whose_wall_is_turned_is_still_a_hole) {
    Mesh mesh = shapes::plate_with_hole(40, 3, 8, 32);
    for (std::size_t t = 64; t < 128; ++t) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    EXPECT_NEAR(sliced_volume(slice(mesh, exact(0.5))),
                std::abs(volume(shapes::plate_with_hole(40, 3, 8, 32))), 1e-2);
}

// Two boxes of 1 mm, the upper one smaller: its corners and faces lie on the second layer's cut.
TEST(slice, faces_and_points_on_the_cut_belong_to_one_side) {
    const Mesh steps = shapes::together(shapes::box({10, 10, 0.3}),
                                        moved(shapes::box({5, 5, 0.3}), 0, {0, 0, 0.3}));
    const Slices slices = slice(steps, exact(0.2));
    ASSERT_EQ(slices.layers.size(), 3U);
    EXPECT_NEAR(area(slices.layers[0].region), 100, 1e-4);
    EXPECT_NEAR(area(slices.layers[1].region), 25, 1e-4);
    EXPECT_NEAR(area(slices.layers[2].region), 25, 1e-4);
    EXPECT_EQ(slices.dropped_outlines + slices.closed_outlines, 0);
}

// Random points on few heights, so that most cuts go through points and along edges.
RC_GTEST_PROP(slice, closed_meshes_give_closed_outlines, (std::uint64_t seed)) {
    Mesh mesh = shapes::sphere(10, 8);
    std::mt19937_64 random(seed);
    for (Vec3& p : mesh.points) {
        p.z = std::round(p.z * 2) / 2;
        p.x += static_cast<double>(random() % 5) / 2;
    }
    for (const double height : {1.0, 0.5, 0.3}) {
        const Slices slices = slice(mesh, exact(height));
        RC_ASSERT(slices.closed_outlines == 0);
        RC_ASSERT(slices.dropped_outlines == 0);
    }
}

// Two of a box's wall triangles are missing above a slit of `gap`.
Mesh slit_box(double gap) {
    Mesh mesh =
        shapes::extruded({{0, 0}, {5, 0}, {5 + gap, 0}, {10, 0}, {10, 10}, {0, 10}}, 2, {5, 5});
    mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
    return mesh;
}

TEST(slice, a_slit_is_closed_and_counted) {
    const Slices slices = slice(slit_box(1), exact(0.2));
    EXPECT_EQ(slices.closed_outlines, 10);
    EXPECT_EQ(slices.dropped_outlines, 0);
    EXPECT_NEAR(sliced_volume(slices), 200, 1e-3);
}

TEST(slice, a_wide_gap_is_given_up_and_counted) {
    const Slices slices = slice(slit_box(3), exact(0.2));
    EXPECT_EQ(slices.closed_outlines, 0);
    EXPECT_EQ(slices.dropped_outlines, 10);
    EXPECT_NEAR(slices.dropped_length, 10 * 37, 1e-6);
    EXPECT_EQ(sliced_volume(slices), 0);
}

RC_GTEST_PROP(slice, corners_that_miss_by_a_hair_are_joined, (std::uint64_t seed)) {
    const Mesh whole = shapes::random_extrusion(seed, 2);
    Mesh soup = shapes::unwelded(whole);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> noise(-1e-5, 1e-5);
    for (Vec3& p : soup.points) p = p + Vec3{noise(random), noise(random), 0};
    const Slices slices = slice(soup, exact(0.4));
    RC_ASSERT(slices.closed_outlines == 5);
    RC_ASSERT(slices.dropped_outlines == 0);
    RC_ASSERT(std::abs(sliced_volume(slices) / volume(whole) - 1) < 1e-4);
}

TEST(slice, any_number_of_threads_gives_the_same) {
    const Mesh mesh = shapes::together(shapes::sphere(20, 40), shapes::random_extrusion(3, 30));
    SliceOptions options{.layer_height = 0.1, .first_layer_height = 0.3, .threads = 1};
    const Slices one = slice(mesh, options);
    options.threads = 4;
    const Slices four = slice(mesh, options);
    ASSERT_EQ(one.layers.size(), four.layers.size());
    for (std::size_t i = 0; i < one.layers.size(); ++i)
        EXPECT_TRUE(one.layers[i].region == four.layers[i].region) << "layer " << i;
}

TEST(slice, tells_how_far_it_is) {
    std::vector<double> told;
    SliceOptions options = exact(0.05);
    options.progress = [&](double fraction, std::string_view) { told.push_back(fraction); };
    slice(shapes::box({1, 1, 20}), options);
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_GE(told.size(), 4U);
    EXPECT_EQ(told.back(), 1);
}

}  // namespace
}  // namespace bead
