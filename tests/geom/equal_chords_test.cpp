#include "geom/equal_chords.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "support/curves.h"

namespace bead {
namespace {

TEST(EqualChords, of_an_arc_are_even_turns) {
    const Nurbs arc = nurbs_of(PlanarArc{{3, 4}, 10, 0.2, 2});
    const ChordWalk walk = equal_chords(arc, 0.5);
    const double turn = 2 * std::asin(0.025);
    ASSERT_EQ(walk.points.size(), static_cast<std::size_t>(2 / turn) + 2);
    for (std::size_t i = 0; i + 1 < walk.points.size(); ++i)
        EXPECT_LT(distance(walk.points[i], Vec2{3, 4} + 10 * unit(0.2 + turn * double(i))), 1e-5);
    EXPECT_LT(distance(walk.points.back(), Vec2{3, 4} + 10 * unit(2.2)), 1e-12);
}

TEST(EqualChords, longer_than_the_curve_leave_its_ends) {
    EXPECT_EQ(equal_chords(bezier({{0, 0}, {1, 1}, {2, 0}}), 5).points.size(), 2U);
}

TEST(EqualChords, keep_to_the_first_place_at_their_distance) {
    const Nurbs hairpin = bezier({{0, 0}, {30, 0}, {30, 2}, {0, 2}});
    const ChordWalk walk = equal_chords(hairpin, 1.5);
    EXPECT_GT(walk.points.size(), 25U);
    EXPECT_TRUE(std::ranges::is_sorted(walk.parameters));
    EXPECT_LT(speed_fluctuation(walk.points, 1.5), 1e-6);
}

// Wild cubics, weights 1 to 1.8, of about 100 mm, wherever there is but one answer.
RC_GTEST_PROP(EqualChords, are_even_to_a_millionth, (unsigned seed)) {
    test::RandomRegions random(seed);
    const Nurbs curve = test::wild_cubic(random);
    const double chord = random.uniform(0.1, 2);
    RC_PRE(chord < 2 / peak_curvature(curve));
    const ChordWalk walk = equal_chords(curve, chord);
    RC_ASSERT(std::ranges::is_sorted(walk.parameters));
    RC_ASSERT(speed_fluctuation(walk.points, chord) < 1e-6);
}

// Where a chord leads past a place at which the parameter nearly stands still, one or two more.
TEST(EqualChords, take_three_steps_at_most_but_for_one_in_a_hundred_thousand) {
    std::size_t points = 0, more = 0;
    for (unsigned seed = 0; seed < 3000; ++seed) {
        test::RandomRegions random(seed);
        const Nurbs curve = test::wild_cubic(random);
        const double chord = random.uniform(0.1, 2);
        if (chord >= 2 / peak_curvature(curve)) continue;
        for (const int steps : equal_chords(curve, chord).steps) {
            ++points;
            more += steps > 3 ? 1 : 0;
        }
    }
    EXPECT_GT(points, 300000U);
    EXPECT_LE(more * 100000, points);
}

// Foretold by Taylor's second order only, the error falls with the square of the chord.
TEST(EqualChords, need_their_correction) {
    test::RandomRegions random(1);
    const Nurbs curve = test::wild_cubic(random);
    double before = 0;
    for (const double chord : {0.2, 0.1, 0.05}) {
        const double uneven =
            speed_fluctuation(equal_chords(curve, chord, {.most_steps = 0}).points, chord);
        EXPECT_GT(uneven, 1e-6);
        if (before > 0) {
            EXPECT_GT(before / uneven, 3);
        }
        before = uneven;
    }
}

}  // namespace
}  // namespace bead
