#include "scene/svg.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <vector>

namespace bead {
namespace {

TEST(Svg, NumbersAreShort) {
    EXPECT_EQ(decimal(3), "3");
    EXPECT_EQ(decimal(1.5), "1.5");
    EXPECT_EQ(decimal(-0.25), "-0.25");
    EXPECT_EQ(decimal(0.0004), "0");
    EXPECT_EQ(decimal(-0.0004), "0");
    EXPECT_EQ(decimal(1200.001), "1200.001");
}

TEST(Svg, TextKeepsItsMeaning) {
    EXPECT_EQ(escaped("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
    EXPECT_EQ(escaped("45° \x01\n"), "45°   ");
}

TEST(Svg, AStrokeNeedsLength) {
    EXPECT_EQ(stroke_data({}), "");
    EXPECT_EQ(stroke_data(std::vector<Vec3>{{1, 2, 0}}), "");
    EXPECT_EQ(stroke_data(std::vector<Vec3>{{1, 2, 0}, {1, 2, 0}, {1.0001, 2, 0}}), "");
    EXPECT_EQ(stroke_data(std::vector<Vec3>{{1, 2, 0}, {3, 2.5, 0}, {3, 2, 1}}),
              "M1 -2l2 -0.5 0 0.5");
}

TEST(Svg, NamesFollowTheContent) {
    EXPECT_EQ(content_name("M0 0l1 1"), content_name("M0 0l1 1"));
    EXPECT_NE(content_name("M0 0l1 1"), content_name("M0 0l1 2"));
    EXPECT_EQ(content_name(""), "bcbf29ce484222325");  // FNV-1a of nothing
}

// Sums up the steps of a stroke's data.
std::vector<Vec2> points_of(const std::string& data) {
    std::vector<Vec2> points;
    Vec2 at;
    const char* next = data.c_str() + 1;
    while (*next) {
        char* end = nullptr;
        const double x = std::strtod(next, &end);
        const double y = std::strtod(end, &end);
        at = at + Vec2{x, y};
        points.push_back(at);
        next = *end ? end + 1 : end;
    }
    return points;
}

RC_GTEST_PROP(Svg, RoundingDoesNotAddUp, ()) {
    const int count = *rc::gen::inRange(2, 500);
    std::vector<Vec3> line{{0, 0, 0}};
    for (int i = 1; i < count; ++i) {
        const double step = *rc::gen::inRange(1, 9999) * 1e-3 + 0.0004;
        line.push_back({line.back().x + step, line.back().y - step / 3, 0});
    }
    const std::vector<Vec2> drawn = points_of(stroke_data(line));
    RC_ASSERT(drawn.size() == line.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
        RC_ASSERT(std::abs(drawn[i].x - line[i].x) < 0.000501);
        RC_ASSERT(std::abs(drawn[i].y + line[i].y) < 0.000501);
    }
}

}  // namespace
}  // namespace bead
