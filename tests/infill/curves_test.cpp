// What makes each curve the one that it is named for.
#include <gtest/gtest.h>

#include <set>

#include "infill/fill.h"
#include "support/regions.h"

namespace bead {
namespace {

double total(const std::vector<Polyline>& lines) {
    double sum = 0;
    for (const Polyline& line : lines) sum += length(line);
    return sum;
}

TEST(Archimedean, is_one_spiral_that_chords_leave_by_a_hundredth) {
    constexpr double spacing = 2.5, rise = spacing / (2 * pi), angle = 0.4;
    const auto lines =
        archimedean(test::disc({1, 2}, 40, 360),
                    {.spacing = spacing, .angle = angle, .link = 0, .centre = {1, 2}});
    const Polyline& spiral = *std::max_element(
        lines.begin(), lines.end(),
        [](const Polyline& a, const Polyline& b) { return length(a) < length(b); });
    EXPECT_GT(length(spiral), 0.9 * pi * 40 * 40 / spacing);
    const auto off_by = [&](Vec2 p) {  // mm, outwards
        const Vec2 from_centre = p - Vec2{1, 2};
        const double turned = std::atan2(from_centre.y, from_centre.x) - angle;
        const double r = length(from_centre);
        return rise * std::remainder(r / rise - turned, 2 * pi);
    };
    for (std::size_t i = 1; i < spiral.size(); ++i) {
        const Vec2 middle = lerp(spiral[i - 1], spiral[i], 0.5);
        const bool cut_end = i == 1 || i + 1 == spiral.size();
        if (spiral[i] == Vec2{1, 2}) continue;  // the centre has no direction
        EXPECT_NEAR(off_by(spiral[i]), 0, cut_end ? 0.02 : 1e-9);
        if (length(middle - Vec2{1, 2}) > spacing) {
            EXPECT_NEAR(off_by(middle), 0, 0.0105);
        }
    }
}

TEST(Archimedean, follows_no_turns_far_from_the_region) {
    const auto lines = archimedean(test::disc({1000, 0}, 3), {.spacing = 1, .angle = 0, .link = 0});
    EXPECT_NEAR(total(lines), pi * 9, 2);
    EXPECT_LE(lines.size(), 7U);
}

TEST(Hilbert, visits_every_cell_once_in_steps_of_one_spacing) {
    constexpr double spacing = 1.5;
    const Region square = test::square(60 * spacing);  // edges between cells, centre on a corner
    std::set<std::pair<long, long>> cells;
    std::size_t visits = 0;
    for (const Polyline& line : hilbert(square, {.spacing = spacing, .link = 0}))
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Vec2 step = line[i] - line[i - 1];
            EXPECT_NEAR(std::min(std::abs(step.x), std::abs(step.y)), 0, 1e-9);
            const auto halves = std::lround(length(step) / spacing * 2);
            EXPECT_NEAR(length(step) / spacing * 2, static_cast<double>(halves), 1e-6);
            for (long k = 0; k <= halves; ++k) {  // cell centres are odd halves from the centre
                const Vec2 p = lerp(line[i - 1], line[i],
                                    static_cast<double>(k) / static_cast<double>(halves));
                const auto x = std::lround(std::floor(p.x / spacing));
                const auto y = std::lround(std::floor(p.y / spacing));
                const Vec2 middle =
                    spacing * Vec2{static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5};
                const bool corner_again = k == 0 && i > 1;
                if (distance(p, middle) > 1e-6 || corner_again) continue;
                ++visits;
                cells.insert({x, y});
            }
        }
    EXPECT_EQ(visits, 3600U);
    EXPECT_EQ(cells.size(), 3600U);
}

TEST(Hilbert, of_a_small_region_is_nearly_one_line) {
    EXPECT_LE(hilbert(test::square(20), {.spacing = 1}).size(), 6U);
}

TEST(Octagram, is_the_same_after_an_eighth_of_a_turn_but_for_the_joints) {
    const Region disc = test::disc({}, 30, 720);
    const double here = total(octagram(disc, {.spacing = 1, .angle = 0.1, .link = 0}));
    const double there = total(octagram(disc, {.spacing = 1, .angle = 0.1 + pi / 4, .link = 0}));
    EXPECT_NEAR(there / here, 1, 0.001);
}

TEST(Octagram, runs_straight_in_eight_directions_but_for_the_joints) {
    std::set<long> directions;
    double joints = 0, sum = 0;
    for (const Polyline& line : octagram(test::disc({}, 30, 720), {.spacing = 1, .link = 0}))
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Vec2 step = line[i] - line[i - 1];
            const double eighths = (std::atan2(step.y, step.x) / pi + 2) * 8 + 1;
            sum += length(step);
            if (std::abs(std::remainder(eighths, 2)) > 1e-6)
                joints += length(step);
            else
                directions.insert(std::lround(eighths) % 16);
        }
    EXPECT_EQ(directions.size(), 8U);
    EXPECT_LT(joints, 0.1 * sum);
}

TEST(Concentric, loops_are_closed_and_one_spacing_apart) {
    const auto lines = concentric(test::square(20), {.spacing = 2});
    std::set<long> sides;
    for (const Polyline& line : lines) {
        if (line.front() == line.back()) sides.insert(std::lround(bounds(line).size().x));
    }
    EXPECT_EQ(sides, (std::set<long>{4, 8, 12, 16, 20}));
}

TEST(Concentric, a_narrow_middle_gets_one_line) {
    const Region bar = test::rectangle({0, 0}, {40, 3.2});
    const auto lines = concentric(bar, {.spacing = 2});
    ASSERT_EQ(lines.size(), 2U);
    const Polyline& middle = lines[0].front() == lines[0].back() ? lines[1] : lines[0];
    EXPECT_NEAR(length(middle), 38, 1);
    for (const Vec2 p : middle) EXPECT_NEAR(p.y, 1.6, 0.61);
}

TEST(Concentric, loops_start_towards_the_angle) {
    for (const double angle : {0.0, 1.0, -2.5})
        for (const Polyline& line :
             concentric(test::disc({5, 5}, 20, 90), {.spacing = 2, .angle = angle})) {
            if (length(line) < 20) continue;
            const Vec2 start = line.front() - Vec2{5, 5};
            EXPECT_NEAR(dot(start, unit(angle)), length(start), 0.01 * length(start));
        }
}

}  // namespace
}  // namespace bead
