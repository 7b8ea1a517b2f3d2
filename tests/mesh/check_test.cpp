#include "mesh/check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mesh/orient.h"
#include "support/shapes.h"

namespace bead {
namespace {

TEST(check, shapes_are_watertight) {
    for (const Mesh& mesh :
         {shapes::box({1, 2, 3}), shapes::sphere(5, 12), shapes::cylinder(3, 4, 17),
          shapes::plate_with_hole(20, 3, 5, 24), shapes::inside_out(shapes::box({1, 2, 3}))}) {
        EXPECT_TRUE(check(mesh).is_watertight());
        EXPECT_EQ(check(mesh).degenerate, 0);
    }
}

RC_GTEST_PROP(check, a_missing_triangle_leaves_three_open_edges, ()) {
    Mesh mesh = shapes::sphere(5, 10);
    mesh.triangles.erase(mesh.triangles.begin() +
                         *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(mesh.triangles)));
    RC_ASSERT(check(mesh).open_edges == 3);
    RC_ASSERT(check(mesh).flipped_edges == 0);
}

RC_GTEST_PROP(check, a_turned_triangle_quarrels_with_three_neighbours, ()) {
    Mesh mesh = shapes::sphere(5, 10);
    auto& triangle = mesh.triangles[*rc::gen::inRange<std::size_t>(0, mesh.triangles.size())];
    std::swap(triangle[0], triangle[1]);
    RC_ASSERT(check(mesh).flipped_edges == 3);
    RC_ASSERT(check(mesh).open_edges == 0);
}

TEST(check, loose_triangles_have_only_open_edges) {
    const Mesh soup = shapes::unwelded(shapes::box({1, 2, 3}));
    EXPECT_EQ(check(soup).open_edges, 3 * std::ssize(soup.triangles));
}

TEST(check, counts_edges_of_more_than_two_and_triangles_without_area) {
    Mesh mesh{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 2}}, {}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}, {2, 2, 3}};
    EXPECT_EQ(check(mesh).non_manifold_edges, 1);
    EXPECT_EQ(check(mesh).degenerate, 2);
}

RC_GTEST_PROP(orient, turns_the_odd_ones_back, (std::uint64_t seed)) {
    const Mesh whole = shapes::together(shapes::sphere(5, 10), shapes::box({1, 2, 3}));
    Mesh mesh = whole;
    std::mt19937_64 random(seed);
    for (auto& triangle : mesh.triangles)
        if (random() % 5 == 0) std::swap(triangle[0], triangle[1]);
    const auto agreed = reoriented(mesh, sorted_sides(mesh));
    RC_PRE(agreed.has_value());
    RC_ASSERT(check(*agreed).is_watertight());
    RC_ASSERT(!reoriented(*agreed, sorted_sides(*agreed)).has_value());
}

TEST(orient, leaves_a_shell_that_is_inside_out_alone) {
    const Mesh mesh = shapes::inside_out(shapes::box({1, 2, 3}));
    EXPECT_FALSE(reoriented(mesh, sorted_sides(mesh)).has_value());
}

}  // namespace
}  // namespace bead
