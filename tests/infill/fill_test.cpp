// Laws that every pattern keeps, those of tomorrow included: each test goes through the whole
// table.
#include "infill/fill.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <ostream>

#include "geom/clip.h"
#include "support/regions.h"

namespace bead {
namespace {

using test::RandomRegions;

double total_length(const std::vector<Polyline>& lines) {
    double sum = 0;
    for (const Polyline& line : lines) sum += length(line);
    return sum;
}

bool is_concentric(const NamedPattern& pattern) { return pattern.make == concentric; }

bool inside(const Region& region, Vec2 p) {
    return contains(region, p) || boundary_distance(region, p) < 1e-3;
}

// Spacing and angle of every kind; links none, short or of any length.
FillOptions random_options(RandomRegions& random) {
    constexpr std::array links{0.0, 4.0, 1e9};
    return {.spacing = random.uniform(0.4, 5),
            .angle = random.uniform(-7, 7),
            .link = links.at(static_cast<std::size_t>(random.whole(0, 2))),
            .centre = random.point(40)};
}

TEST(Fill, of_nothing_is_nothing) {
    for (const NamedPattern& pattern : patterns)
        EXPECT_TRUE(pattern.make({}, {}).empty()) << pattern.name;
}

// Away from edges there is 1 / spacing of line per area. Where the edge falls between two lines
// makes less than half a spacing along it, here below 1 %. Concentric lies on the edge itself: half
// a perimeter more.
TEST(Fill, lays_one_line_per_spacing) {
    const Region square = test::square(200);
    for (const NamedPattern& pattern : patterns)
        for (const double spacing : {0.5, 1.1, 2.3}) {
            const double extra = is_concentric(pattern) ? perimeter(square) / 2 : 0;
            const double expected = area(square) / spacing + extra;
            const FillOptions options{.spacing = spacing, .angle = 0.3, .link = 0};
            EXPECT_NEAR(total_length(pattern.make(square, options)) / expected, 1, 0.01)
                << pattern.name << ' ' << spacing;
        }
}

TEST(Fill, changes_little_when_the_spacing_changes_little) {
    const Region region = difference(test::ell(80, 35), test::disc({15, 15}, 8));
    for (const NamedPattern& pattern : patterns) {
        const auto amount = [&](double spacing) {
            return spacing * total_length(pattern.make(region, {.spacing = spacing, .angle = 0.4}));
        };
        for (double spacing = 1; spacing < 3; spacing += 0.23)
            EXPECT_NEAR(amount(spacing * 1.001) / amount(spacing), 1, 0.03)
                << pattern.name << ' ' << spacing;
    }
}

RC_GTEST_PROP(Fill, stays_inside, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    const FillOptions options = random_options(random);
    for (const NamedPattern& pattern : patterns)
        for (const Polyline& line : pattern.make(region, options))
            for (std::size_t i = 1; i < line.size(); ++i) {
                RC_ASSERT(inside(region, line[i - 1]));
                RC_ASSERT(inside(region, line[i]));
                RC_ASSERT(inside(region, lerp(line[i - 1], line[i], 0.37)));
            }
}

RC_GTEST_PROP(Fill, has_no_line_too_short_to_print, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    const FillOptions options = random_options(random);
    for (const NamedPattern& pattern : patterns)
        for (const Polyline& line : pattern.make(region, options)) RC_ASSERT(length(line) >= 1e-3);
}

RC_GTEST_PROP(Fill, is_the_same_each_time, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    const FillOptions options = random_options(random);
    for (const NamedPattern& pattern : patterns)
        RC_ASSERT(pattern.make(region, options) == pattern.make(region, options));
}

// Offsets are rounded to 1 nm, which may open or close the last gap in the middle of concentric
// loops, in more than one place at once.
RC_GTEST_PROP(Fill, turns_and_moves_with_the_part, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    FillOptions options = random_options(random);
    options.link = 0;
    const double angle = random.uniform(-3, 3);
    const Vec2 about = random.point(30), shift = random.point(30);
    FillOptions there = options;
    there.angle += angle;
    there.centre = moved(Polyline{options.centre}, angle, about, shift)[0];
    for (const NamedPattern& pattern : patterns) {
        const double here_length = total_length(pattern.make(region, options));
        const double there_length =
            total_length(pattern.make(moved(region, angle, about, shift), there));
        const double slack =
            is_concentric(pattern) ? 0.02 * here_length + 2 * options.spacing : 0.01;
        RC_ASSERT(std::abs(here_length - there_length) <= slack);
    }
}

// Layers stack: what is laid in a region is what is laid around it, cut by the region (by Clipper).
RC_GTEST_PROP(Fill, does_not_depend_on_the_region, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    FillOptions options = random_options(random);
    options.link = 0;
    options.spacing = random.uniform(2, 8);  // Clipper takes seconds to cut thousands of lines
    const Box2 box = bounds(region);
    const Region plate = test::rectangle(box.low - Vec2{7, 5}, box.high + Vec2{3, 9});
    for (const NamedPattern& pattern : patterns) {
        if (is_concentric(pattern)) continue;
        const std::vector<Polyline> around = pattern.make(plate, options);
        const double expected = total_length(inside_parts(around, region));
        RC_ASSERT(std::abs(total_length(pattern.make(region, options)) - expected) < 0.02);
    }
}

// Links lie on the edge and no piece of it is used twice; they only ever join.
RC_GTEST_PROP(Fill, links_join_lines_along_the_edge, (unsigned seed)) {
    RandomRegions random(seed);
    const Region region = random.any();
    FillOptions options = random_options(random);
    for (const NamedPattern& pattern : patterns) {
        options.link = 0;
        const auto loose = pattern.make(region, options);
        options.link = 2 * options.spacing;
        const auto some = pattern.make(region, options);
        options.link = 1e9;
        const auto joined = pattern.make(region, options);
        RC_ASSERT(some.size() <= loose.size());
        RC_ASSERT(joined.size() <= loose.size());
        const double added = total_length(some) - total_length(loose),
                     most = total_length(joined) - total_length(loose);
        const auto links = static_cast<double>(loose.size() - some.size());
        RC_ASSERT(added >= -1e-6);
        RC_ASSERT(added <= links * 2 * options.spacing + 1e-6);
        RC_ASSERT(most >= -1e-6);
        RC_ASSERT(most <= perimeter(region) + 1e-6);
    }
}

}  // namespace
}  // namespace bead
