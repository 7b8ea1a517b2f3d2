#include "scene/layer_picture.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "scene/drawing.h"
#include "scene/looks.h"

namespace bead {
namespace {

std::size_t count(std::string_view text, std::string_view part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

// Every tag is closed in its turn and nothing between them could be taken for a tag.
bool is_well_formed(std::string_view xml) {
    std::vector<std::string_view> open;
    for (std::size_t at = 0; at < xml.size();) {
        const std::size_t start = std::min(xml.find('<', at), xml.size());
        if (xml.substr(at, start - at).find('>') != std::string_view::npos) return false;
        if (start == xml.size()) break;
        const std::size_t end = xml.find('>', start);
        if (end == std::string_view::npos) return false;
        std::string_view tag = xml.substr(start + 1, end - start - 1);
        at = end + 1;
        if (count(tag, "\"") % 2 != 0) return false;
        if (tag.ends_with('/')) continue;
        const std::string_view name = tag.substr(0, tag.find(' '));
        if (!name.starts_with('/')) {
            open.push_back(name);
        } else {
            if (open.empty() || open.back() != name.substr(1)) return false;
            open.pop_back();
        }
    }
    return open.empty();
}

Path line(Role role, Vec2 from, Vec2 to, double width = 0.45) {
    Path path;
    path.role = role;
    if (role != Role::travel) path.bead = {width, 0.2};
    path.points = {at_height(from, 0.2), at_height(to, 0.2)};
    return path;
}

Toolpath random_layer(unsigned seed, int paths) {
    std::mt19937 random(seed);
    const auto place = [&] {
        std::uniform_real_distribution<double> mm(0, 100);
        const double x = mm(random);
        return Vec2{x, mm(random)};
    };
    Toolpath layer;
    for (int i = 0; i < paths; ++i) {
        const Vec2 from = place();
        layer.push_back(line(Role(random() % role_names.size()), from, place()));
    }
    return layer;
}

std::string picture(const Toolpath& layer, const std::string& text = "") {
    const std::vector<Panel> panels{{text, layer, text}};
    return layer_picture(panels, text);
}

TEST(LayerPicture, KnowsTheLookOfEveryRole) {
    for (std::size_t role = 0; role < role_names.size(); ++role)
        EXPECT_EQ(std::ranges::count(looks, Role(role), &Look::role), 1) << role_names[role];
}

TEST(LayerPicture, BeadsHaveTheirWidth) {
    const std::string svg = picture({line(Role::infill, {0, 0}, {10, 0}, 0.6)});
    EXPECT_EQ(count(svg, "stroke-width=\"0.6\""), 1U);
    const std::string wide = picture({line(Role::infill, {0, 0}, {10, 0}, 9.5)});
    EXPECT_EQ(count(wide, "stroke-width=\"9.5\""), 1U);
}

TEST(LayerPicture, LegendNamesWhatOccurs) {
    const std::string svg =
        picture({line(Role::outer_wall, {0, 0}, {9, 0}), line(Role::top_skin, {0, 1}, {9, 1})});
    EXPECT_EQ(count(svg, ">outer wall<"), 1U);
    EXPECT_EQ(count(svg, ">top skin<"), 1U);
    EXPECT_EQ(count(svg, ">infill<"), 0U);
    EXPECT_EQ(count(svg, ">travel<"), 0U);
}

TEST(LayerPicture, TravelFromFarAwayDoesNotShrinkTheLayer) {
    Toolpath layer{line(Role::infill, {100, 100}, {110, 105})};
    const Box2 before = extent(layer);
    layer.push_back(line(Role::travel, {0, 0}, {100, 100}));
    EXPECT_EQ(extent(layer).low, before.low);
    EXPECT_EQ(extent(layer).high, before.high);
    EXPECT_EQ(extent({layer.back()}).high, (Vec2{100, 100}));
}

TEST(LayerPicture, ScaleBarIsRoundAndFits) {
    for (const double size : {0.5, 3.0, 10.0, 77.0, 300.0, 1000.0, 20000.0}) {
        const std::string svg = picture({line(Role::infill, {0, 0}, {size, size})});
        const std::size_t end = svg.rfind(" mm</text>");
        ASSERT_NE(end, std::string::npos);
        const std::size_t start = svg.rfind('>', end) + 1;
        const double bar = std::stod(svg.substr(start, end - start));
        EXPECT_LT(bar, size * 1.2 + 1);
        std::string digits = svg.substr(start, end - start);
        std::erase_if(digits, [](char c) { return c == '0' || c == '.'; });
        EXPECT_TRUE(digits == "1" || digits == "2" || digits == "5") << bar;
    }
}

TEST(LayerPicture, NothingIsAPictureToo) {
    EXPECT_TRUE(is_well_formed(layer_picture({}, "")));
    EXPECT_TRUE(is_well_formed(picture({})));
    Path point = line(Role::wall, {5, 5}, {5, 5});
    EXPECT_TRUE(is_well_formed(picture({point})));
    point.points.clear();
    EXPECT_TRUE(is_well_formed(picture({point})));
}

RC_GTEST_PROP(LayerPicture, DrawsEachPathOnce, (unsigned seed)) {
    const int paths = *rc::gen::inRange(0, 60);
    const Toolpath layer = random_layer(seed, paths);
    const std::string drawn = drawing(layer, {0, 0, 100, 100}, 1);
    RC_ASSERT(count(drawn, "M") == std::size_t(paths));
    RC_ASSERT(is_well_formed(drawn));
}

RC_GTEST_PROP(LayerPicture, IsTheSameBytesEachTime, (unsigned seed)) {
    RC_ASSERT(picture(random_layer(seed, 30), "x") == picture(random_layer(seed, 30), "x"));
}

RC_GTEST_PROP(LayerPicture, AnyTextIsOnlyText, (const std::string& text)) {
    RC_ASSERT(is_well_formed(picture(random_layer(1, 3), text + "</text><g x=\"")));
}

}  // namespace
}  // namespace bead
