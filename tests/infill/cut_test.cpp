#include "infill/cut.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/clip.h"
#include "infill/edge_bands.h"
#include "support/regions.h"

namespace bead {
namespace {

std::vector<CutLine> cut(const Polyline& curve, const Region& region) {
    return cut_to({curve}, measured_loops(region));
}

const Region square = test::rectangle({0, 0}, {10, 10});

TEST(Cut, gives_the_places_on_the_edge) {
    const auto lines = cut({{-5, 4}, {15, 4}}, square);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].points, (Polyline{{0, 4}, {10, 4}}));
    EXPECT_NEAR(lines[0].start.at, 36, 1e-9);
    EXPECT_NEAR(lines[0].end.at, 14, 1e-9);
}

TEST(Cut, ends_inside_have_no_place) {
    const auto lines = cut({{5, 5}, {15, 5}}, square);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].start.loop, -1);
    EXPECT_EQ(lines[0].end.loop, 0);
    EXPECT_TRUE(cut({{5, 12}, {15, 12}}, square).empty());
}

TEST(Cut, a_curve_through_corners_is_cut_once) {
    const auto lines = cut({{-5, -5}, {15, 15}}, square);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_NEAR(length(lines[0].points), 10 * std::numbers::sqrt2, 1e-9);
}

TEST(Cut, a_curve_that_touches_from_inside_stays_whole) {
    EXPECT_EQ(cut({{2, 5}, {5, 0}, {8, 5}}, square).size(), 1U);
    double kept = 0;  // what runs on the edge itself may count either way
    for (const CutLine& part : cut({{2, 5}, {2, 0}, {8, 0}, {8, 5}}, square))
        kept += length(part.points);
    EXPECT_GE(kept, 10 - 1e-6);
    EXPECT_LE(kept, 16 + 1e-6);
}

TEST(Cut, a_curve_that_touches_from_outside_is_not_there) {
    EXPECT_TRUE(cut({{2, -5}, {5, 0}, {8, -5}}, square).empty());
    EXPECT_TRUE(cut({{-3, 3}, {0, 0}, {3, -3}}, square).empty());
}

RC_GTEST_PROP(Cut, keeps_what_clipper_keeps, (unsigned seed)) {
    test::RandomRegions random(seed);
    const Region region = random.any();
    Polyline curve;
    for (int i = 0; i < 200; ++i) curve.push_back(random.point(60));
    double expected = 0, kept = 0;
    for (const Polyline& part : inside_parts({curve}, region)) expected += length(part);
    for (const CutLine& part : cut(curve, region)) kept += length(part.points);
    RC_ASSERT(std::abs(kept - expected) < 0.01);
}

// Corners on the edge's own corners and sides on its sides: the cases that rounding decides.
RC_GTEST_PROP(Cut, holds_on_a_lattice, (unsigned seed)) {
    test::RandomRegions random(seed);
    const auto lattice = [&] {
        return Vec2{static_cast<double>(random.whole(0, 8)),
                    static_cast<double>(random.whole(0, 8))};
    };
    Region region;
    for (int i = 0; i < 5; ++i) {
        const Vec2 low = lattice();
        region = united(region, test::rectangle(low, low + Vec2{2, 2}));
    }
    Polyline curve;
    while (curve.size() < 30) curve.push_back(lattice());
    for (const CutLine& part : cut(curve, region))
        for (std::size_t i = 1; i < part.points.size(); ++i)
            for (const double t : {0.0, 0.41, 1.0}) {
                const Vec2 p = lerp(part.points[i - 1], part.points[i], t);
                RC_ASSERT(contains(region, p) || boundary_distance(region, p) < 1e-6);
            }
}

RC_GTEST_PROP(Cut, ends_lie_where_their_places_say, (unsigned seed)) {
    test::RandomRegions random(seed);
    const std::vector<MeasuredLoop> loops = measured_loops(random.any());
    Polyline curve;
    for (int i = 0; i < 50; ++i) curve.push_back(random.point(60));
    const auto holds = [&](const EdgePlace& place, Vec2 p) {
        return place.loop < 0 ||
               distance(point_at(loops[static_cast<std::size_t>(place.loop)], place.at), p) < 1e-6;
    };
    for (const CutLine& part : cut_to({curve}, loops)) {
        RC_ASSERT(holds(part.start, part.points.front()));
        RC_ASSERT(holds(part.end, part.points.back()));
    }
}

RC_GTEST_PROP(EdgeBands, agree_with_the_plain_test, (unsigned seed)) {
    test::RandomRegions random(seed);
    const Region region = random.any();
    const EdgeBands bands(measured_loops(region));
    for (int i = 0; i < 100; ++i) {
        const Vec2 p = random.point(60);
        RC_ASSERT(bands.contains(p) == contains(region, p));
    }
}

}  // namespace
}  // namespace bead
