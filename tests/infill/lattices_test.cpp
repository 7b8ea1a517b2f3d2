// What makes each pattern of crossing lines or waves the one that it is named for.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "infill/fill.h"
#include "support/regions.h"

namespace bead {
namespace {

double lattice_length(const std::vector<Polyline>& lines) {
    double sum = 0;
    for (const Polyline& line : lines) sum += length(line);
    return sum;
}

constexpr Vec2 centre{3, -4};

FillOptions plain(double spacing) {
    return {.spacing = spacing, .angle = 0.2, .link = 0, .centre = centre};
}

// Distances of the straight lines from the centre, in `spacing`, by the direction they run in.
std::set<std::pair<long, double>> lines_of(const std::vector<Polyline>& lines, double spacing) {
    std::set<std::pair<long, double>> found;
    for (const Polyline& line : lines) {
        const Vec2 way = line.back() - line.front();
        const double turned = std::atan2(way.y, way.x) - 0.2;
        const long sixths = std::lround(turned / (pi / 6) + 12) % 6;
        const Vec2 along = unit(0.2 + static_cast<double>(sixths) * pi / 6);
        EXPECT_NEAR(std::abs(dot(along, way)), length(way), 1e-9);
        const double off = cross(along, line.front() - centre) / spacing;
        found.insert({sixths, std::round(2 * off) / 2});
        EXPECT_NEAR(off, std::round(2 * off) / 2, 1e-9);
    }
    return found;
}

TEST(Line, is_rectilinear_without_links) {
    const Region part = difference(test::ell(60, 25), test::disc({12, 12}, 6));
    FillOptions options = plain(2);
    EXPECT_EQ(separate_lines(part, options), rectilinear(part, options));
    options.link = 1e9;
    for (const Polyline& line : separate_lines(part, options)) EXPECT_EQ(line.size(), 2U);
}

TEST(Grid, has_lines_both_ways_through_the_centre) {
    const auto found = lines_of(grid(test::square(40), plain(2)), 4);
    std::set<long> ways;
    for (const auto& [way, off] : found) {
        ways.insert(way);
        EXPECT_EQ(off, std::round(off));
    }
    EXPECT_EQ(ways, (std::set<long>{0, 3}));
}

// A point on a line of two families lies on one of the third.
TEST(Triangles, meet_three_by_three) {
    const auto found = lines_of(triangles(test::square(60), plain(2)), 6);
    std::set<long> ways;
    for (const auto& [way, off] : found) {
        ways.insert(way);
        EXPECT_EQ(off, std::round(off));  // h1 + h3 = h2 does the rest
    }
    EXPECT_EQ(ways, (std::set<long>{0, 2, 4}));
}

TEST(TriHexagon, meets_two_by_two_half_way_between_the_third) {
    const auto found = lines_of(tri_hexagon(test::square(60), plain(2)), 6);
    EXPECT_GT(found.size(), 20U);
    for (const auto& [way, off] : found) EXPECT_NE(off, std::round(off)) << way;
}

// Right angles and half ones only, and no straight piece longer than two steps across a leg.
TEST(Cross, is_all_short_steps) {
    constexpr double spacing = 2, leg = 2.4066 * spacing / 2;
    double longest = 0;
    for (const Polyline& line : cross_curve(test::square(80), plain(spacing)))
        for (std::size_t i = 2; i + 1 < line.size(); ++i) {
            const Vec2 in = line[i - 1] - line[i - 2], out = line[i] - line[i - 1];
            longest = std::max(longest, length(out));
            const double eighths = std::atan2(cross(in, out), dot(in, out)) / (pi / 4);
            EXPECT_NEAR(eighths, std::round(eighths), 1e-3);
        }
    EXPECT_GT(longest, 0.4 * leg);
    EXPECT_LT(longest, 1.4 * leg);
}

TEST(Cross, of_a_small_region_is_nearly_one_line) {
    EXPECT_LE(cross_curve(test::square(20), {.spacing = 1}).size(), 8U);
}

// With x, y from the centre along the angle and z in rad, all as in the surface's equation.
TEST(Gyroid, lies_on_its_surface) {
    constexpr double spacing = 2, scale = 1.22937878 * spacing / pi;
    for (double height = 0; height < 2 * pi * scale; height += 0.31) {
        FillOptions options = plain(spacing);
        options.height = height;
        double worst = 0;
        for (const Polyline& line : gyroid(test::square(50), options))
            for (std::size_t i = 1; i + 1 < line.size(); ++i) {
                const Vec2 p = rotated(line[i] - centre, unit(-0.2)) / scale;
                const double z = 0.48924954 + height / scale;
                worst = std::max(
                    worst, std::abs(std::sin(p.x) * std::cos(p.y) + std::sin(p.y) * std::cos(z) +
                                    std::sin(z) * std::cos(p.x)));
            }
        EXPECT_LT(worst, 1e-9) << height;
    }
}

TEST(Gyroid, lays_its_share_over_all_heights_and_never_far_from_it) {
    constexpr double spacing = 2, period = 2 * 1.22937878 * spacing;
    const Region square = test::square(150);
    double sum = 0;
    constexpr int heights = 40;
    for (int i = 0; i < heights; ++i) {
        FillOptions options = plain(spacing);
        options.height = period * i / heights;
        const double share = lattice_length(gyroid(square, options)) * spacing / area(square);
        EXPECT_GT(share, 0.93);
        EXPECT_LT(share, 1.25);
        sum += share;
    }
    EXPECT_NEAR(sum / heights, 1, 0.01);
}

}  // namespace
}  // namespace bead
