#include "geom/crossings.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "geom/resample.h"

namespace bead {
namespace {

TEST(Crossings, AreCountedFromTheLinesStart) {
    const std::vector<Polyline> others{{{3, -1}, {3, 1}}, {{-5, 2}, {20, 2}}, {{8, -9}, {8, 0.5}}};
    const std::vector<double> places = Crossings(others).on({{0, 0}, {10, 0}, {10, 5}});
    ASSERT_EQ(places.size(), 3U);
    EXPECT_NEAR(places[0], 3, 1e-12);
    EXPECT_NEAR(places[1], 8, 1e-12);
    EXPECT_NEAR(places[2], 12, 1e-12);
}

// Lines between points of two halves of the plane cross the border an odd number of times; where
// they do, the line is on it, however finely it is divided.
RC_GTEST_PROP(Crossings, LieOnBothLines, ()) {
    const auto coordinate =
        rc::gen::map(rc::gen::inRange(-1000, 1000), [](int k) { return k / 64.0; });
    const auto xs = *rc::gen::container<std::vector<double>>(6, coordinate);
    const auto ys = *rc::gen::container<std::vector<double>>(6, coordinate);
    Polyline line;
    for (std::size_t i = 0; i < xs.size(); ++i) line.push_back({xs[i], ys[i] + 1e-3});
    const std::vector<Polyline> border{{{-20, 0}, {-1.03, 0}, {7.7, 0}, {20, 0}}};
    const std::vector<double> places = Crossings(border).on(line);
    RC_ASSERT((places.size() % 2 == 1) == ((line.front().y > 0) != (line.back().y > 0)));
    RC_ASSERT(std::ranges::is_sorted(places));
    for (const double place : places) RC_ASSERT(std::abs(part_of(line, 0, place).back().y) < 1e-6);
}

}  // namespace
}  // namespace bead
