#include "scene/stacked_areas.h"

#include <gtest/gtest.h>

namespace bead {
namespace {

StackedAreas two_bands() {
    StackedAreas areas;
    areas.title = "a < b";
    areas.unit = "W";
    areas.step = 60;
    areas.bands = {{"low", "#111111", {1, 2, 3}}, {"high", "#222222", {3, 2, 1}}};
    return areas;
}

TEST(StackedAreas, HasOnePathOfItsInkForEachBand) {
    const std::string svg = stacked_areas_svg(two_bands());
    for (const char* ink : {"#111111\"/>", "#222222\"/>"}) EXPECT_NE(svg.find(ink), svg.npos);
    EXPECT_NE(svg.find("a &lt; b"), svg.npos);
    EXPECT_TRUE(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
}

// Both bands are 4 high together at any time, so the upper one's top is level.
TEST(StackedAreas, PutsBandsOnTopOfEachOther) {
    const std::string svg = stacked_areas_svg(two_bands());
    const std::size_t high = svg.rfind("<path d=\"M70 ", svg.rfind("#222222\"/>"));
    const std::string top = svg.substr(high + 13, svg.find('H', high) - high - 13);
    std::size_t at = high;
    for (int i = 0; i < 2; ++i) {
        at = svg.find('L', at + 1);
        const std::size_t space = svg.find(' ', at);
        EXPECT_EQ(svg.substr(space + 1, svg.find('H', at) - space - 1), top);
    }
}

TEST(StackedAreas, DrawsAMachineThatIsOff) {
    StackedAreas areas = two_bands();
    for (Band& band : areas.bands) band.values = {0};
    EXPECT_EQ(stacked_areas_svg(areas).find("nan"), std::string::npos);
}

}  // namespace
}  // namespace bead
