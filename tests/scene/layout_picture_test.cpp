#include "scene/layout_picture.h"

#include <gtest/gtest.h>

namespace bead {
namespace {

LayoutPicture picture() {
    LayoutPicture p;
    p.title = "a < b & c";
    p.caption = "bears 12 N";
    p.part = {{{{0, 0}, {40, 0}, {40, 10}, {0, 10}}, {{{10, 3}, {10, 7}, {14, 7}, {14, 3}}}}};
    p.groups = {{"walls", "#112233", {{{0.3, 0.3}, {39.7, 0.3}}}},
                {"tension", "#b5402f", {{{1, 2}, {30, 8}}, {{2, 2}, {31, 8}}}},
                {"braces", "#3f8f4f", {}}};
    return p;
}

std::size_t occurrences(const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
    return found;
}

TEST(LayoutPicture, IsAWholeFileThatSaysWhatItShows) {
    const std::string svg = layout_picture(picture());
    EXPECT_TRUE(svg.starts_with("<svg") || svg.starts_with("<?xml"));
    EXPECT_NE(svg.find("</svg>"), svg.npos);
    EXPECT_NE(svg.find("bears 12 N"), svg.npos);
    EXPECT_NE(svg.find("a &lt; b &amp; c"), svg.npos);
    EXPECT_EQ(svg.find("a < b"), svg.npos);
}

// One stroke per group that has lines, in its ink; the key names it.
TEST(LayoutPicture, DrawsEachGroupInItsInk) {
    const std::string svg = layout_picture(picture());
    EXPECT_EQ(occurrences(svg, "fill=\"none\" stroke=\"#b5402f\""), 1U);
    EXPECT_GE(occurrences(svg, "#112233"), 1U);
    EXPECT_NE(svg.find(">tension<"), svg.npos);
    EXPECT_EQ(occurrences(svg, "fill=\"none\" stroke=\"#3f8f4f\""), 0U);
}

TEST(LayoutPicture, LaterGroupsLieOnTop) {
    const std::string svg = layout_picture(picture());
    EXPECT_LT(svg.find("stroke=\"#112233\""), svg.find("stroke=\"#b5402f\""));
}

TEST(LayoutPicture, IsTheSameEachTimeAndOfNothingToo) {
    EXPECT_EQ(layout_picture(picture()), layout_picture(picture()));
    LayoutPicture empty = picture();
    empty.groups.clear();
    EXPECT_NE(layout_picture(empty).find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace bead
