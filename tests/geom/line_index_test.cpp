#include "geom/line_index.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "geom/resample.h"

namespace bead {
namespace {

std::vector<Polyline> random_lines(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-20, 20), step(-3, 3);
    std::vector<Polyline> lines(5);
    for (Polyline& line : lines) {
        line.push_back({place(random), place(random)});
        for (int i = 0; i < 8; ++i) line.push_back(line.back() + Vec2{step(random), step(random)});
    }
    return lines;
}

double slow_distance(const std::vector<Polyline>& lines, Vec2 p) {
    double least = 1e300;
    for (const Polyline& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Vec2 way = line[i] - line[i - 1];
            const double t = std::clamp(dot(p - line[i - 1], way) / dot(way, way), 0.0, 1.0);
            least = std::min(least, distance(p, line[i - 1] + t * way));
        }
    return least;
}

RC_GTEST_PROP(LineIndex, FindsWhatLookingAtAllFinds, (unsigned seed)) {
    const std::vector<Polyline> lines = random_lines(seed);
    const LineIndex index(lines, 1.3);
    std::mt19937 random(seed + 1);
    std::uniform_real_distribution<double> place(-25, 25);
    for (int i = 0; i < 50; ++i) {
        const Vec2 p{place(random), place(random)};
        const double exact = slow_distance(lines, p);
        const auto near = index.nearest(p, 4);
        RC_ASSERT(near.has_value() == (exact < 4));
        if (!near) continue;
        RC_ASSERT(std::abs(near->distance - exact) < 1e-9);
        RC_ASSERT(std::abs(distance(near->at, p) - exact) < 1e-9);
        RC_ASSERT(near->along <= length(lines[near->line]) + 1e-9);
    }
}

TEST(Resampled, KeepsEndsAndLengthsAndIsEven) {
    const Polyline line{{0, 0}, {3, 0}, {3, 4}};
    const Polyline even = resampled(line, 0.5);
    EXPECT_EQ(even.front(), line.front());
    EXPECT_EQ(even.back(), line.back());
    EXPECT_EQ(even.size(), 15u);
    EXPECT_NEAR(length(even), 7, 1e-9);
}

TEST(PartOf, CutsByLength) {
    const Polyline part = part_of({{0, 0}, {3, 0}, {3, 4}}, 2, 5);
    ASSERT_EQ(part.size(), 3u);
    EXPECT_EQ(part.front(), (Vec2{2, 0}));
    EXPECT_EQ(part.back(), (Vec2{3, 2}));
}

TEST(ShiftedAside, KeepsTheDistance) {
    Polyline circle;
    for (int i = 0; i <= 40; ++i) circle.push_back(10.0 * unit(i * 0.05));
    const Polyline aside = shifted_aside(circle, 0.5);
    for (std::size_t i = 1; i + 1 < aside.size(); ++i) EXPECT_NEAR(length(aside[i]), 9.5, 1e-6);
}

}  // namespace
}  // namespace bead
