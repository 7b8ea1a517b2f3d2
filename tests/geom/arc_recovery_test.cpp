#include "geom/arc_recovery.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/regions.h"

namespace bead {
namespace {

Polyline chords(const PlanarArc& arc, int count) {
    Polyline line;
    for (int i = 0; i <= count; ++i) line.push_back(point_at(arc, static_cast<double>(i) / count));
    return line;
}

TEST(ArcRecovery, a_round_corner_between_lines_is_one_arc) {
    Polyline line{{-20, 0}};
    for (const Vec2 p : chords({{0, 6}, 6, -pi / 2, pi / 2}, 12)) line.push_back(p);
    line.push_back({6, 30});
    const auto pieces = arcs_and_lines(line, {});
    ASSERT_EQ(pieces.size(), 3U);
    EXPECT_FALSE(pieces[0].arc);
    EXPECT_FALSE(pieces[2].arc);
    ASSERT_TRUE(pieces[1].arc);
    EXPECT_NEAR(pieces[1].arc->radius, 6, 1e-9);
    EXPECT_NEAR(pieces[1].arc->sweep, pi / 2, 1e-9);
    EXPECT_LT(distance(pieces[1].arc->centre, {0, 6}), 1e-9);
}

TEST(ArcRecovery, a_circle_needs_two_arcs) {
    const auto pieces = arcs_and_lines(chords({{171, 112}, 17, 1, -2 * pi}, 75), {});
    ASSERT_EQ(pieces.size(), 2U);
    for (const PathPiece& piece : pieces) {
        ASSERT_TRUE(piece.arc);
        EXPECT_NEAR(piece.arc->radius, 17, 1e-8);
        EXPECT_LT(piece.arc->sweep, 0);
    }
}

TEST(ArcRecovery, straight_lines_and_squares_stay) {
    for (const PathPiece& piece :
         arcs_and_lines({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}, {}))
        EXPECT_FALSE(piece.arc);
    Polyline gon = test::regular({}, 20, 6);  // on a circle, but no arc
    for (const PathPiece& piece : arcs_and_lines(gon, {})) EXPECT_FALSE(piece.arc);
    EXPECT_TRUE(arcs_and_lines({{1, 1}}, {}).empty());
}

// Arcs of all radii one after the other, tangent to each other, points a little off.
Polyline noisy_bends(test::RandomRegions& random) {
    Vec2 at = random.point(50);
    double heading = random.uniform(0, 7);
    Polyline line{at};
    for (int bend = 0; bend < 10; ++bend) {
        const double radius = std::exp(random.uniform(-0.5, 5)), sweep = random.uniform(-3, 3);
        const double side = sweep > 0 ? 1 : -1;
        const Vec2 centre = at + side * radius * left_of(unit(heading));
        const PlanarArc arc{centre, radius, heading - side * pi / 2, sweep};
        for (const Vec2 p : chords(arc, random.whole(3, 60)))
            line.push_back(p + random.point(0.004));
        at = point_at(arc, 1);
        heading += sweep;
    }
    return line;
}

RC_GTEST_PROP(ArcRecovery, keeps_its_tolerances, (unsigned seed)) {
    test::RandomRegions random(seed);
    const Polyline line = noisy_bends(random);
    const ArcOptions options{.tolerance = random.uniform(0.002, 0.05)};
    std::size_t expected = 0, arcs = 0;
    for (const PathPiece& piece : arcs_and_lines(line, options)) {
        RC_ASSERT(piece.first == expected);
        expected = piece.last;
        if (!piece.arc) {
            RC_ASSERT(piece.last == piece.first + 1);
            continue;
        }
        ++arcs;
        RC_ASSERT(distance(point_at(*piece.arc, 0), line[piece.first]) < 1e-9);
        RC_ASSERT(distance(point_at(*piece.arc, 1), line[piece.last]) < 1e-9);
        for (std::size_t i = piece.first; i <= piece.last; ++i)
            RC_ASSERT(std::abs(distance(line[i], piece.arc->centre) - piece.arc->radius) <=
                      options.tolerance + 1e-12);
    }
    RC_ASSERT(expected + 1 == line.size());
    RC_ASSERT(arcs > 0U);
}

}  // namespace
}  // namespace bead
