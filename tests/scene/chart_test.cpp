#include "scene/chart.h"

#include <gtest/gtest.h>

namespace bead {
namespace {

Chart a_chart() {
    return {"a < b",
            {"x", 0, 10},
            {"y", -1, 1},
            {{"line", chart_inks[0], ChartMark::curve, {{0, 0}, {10, 1}}},
             {"points", chart_inks[1], ChartMark::dots, {{5, 0}, {5, 0.5}, {11, 0}, {5, 2}}},
             {"", chart_inks[2], ChartMark::rings, {{1, 1}}}}};
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(Chart, LeavesOutWhatLiesOutsideTheAxes) {
    const std::string text = chart(a_chart());
    EXPECT_EQ(count(text, "<circle"), 2U + 1 + 1);  // two points, one ring, one mark in the key
    EXPECT_EQ(count(text, "<path fill=\"none\""), 1U);
}

TEST(Chart, BreaksACurveWhereItLeavesTheAxes) {
    Chart picture = a_chart();
    picture.series = {
        {"", chart_inks[0], ChartMark::curve, {{0, 0}, {2, 0}, {4, 5}, {6, 0}, {8, 0}}}};
    const std::string text = chart(picture);
    EXPECT_EQ(count(text, "d=\"M70 246L190 246M430 246L550 246\""), 1U);
}

TEST(Chart, PutsPointsWhereTheyBelong) {
    Chart picture = a_chart();
    picture.series = {{"", chart_inks[0], ChartMark::dots, {{5, 0}}}};
    EXPECT_EQ(count(chart(picture), "cx=\"370\" cy=\"246\""), 1U);  // the middle of the plot
}

TEST(Chart, EscapesWordsAndNamesOnlyWhatHasAName) {
    const std::string text = chart(a_chart());
    EXPECT_EQ(count(text, "a &lt; b"), 1U);
    EXPECT_EQ(count(text, ">line<"), 1U);
    EXPECT_EQ(text, chart(a_chart()));
}

}  // namespace
}  // namespace bead
