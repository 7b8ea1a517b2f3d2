#include "job/nearest_name.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

namespace bead {
namespace {

constexpr std::array<std::string_view, 5> names{"layer_height_mm", "first_layer_height_mm", "walls",
                                                "speed_wall_mm_s", "fan"};

TEST(NearestName, ForgivesSlipsAndMissingUnits) {
    EXPECT_EQ(nearest_name("wals", names), "walls");
    EXPECT_EQ(nearest_name("layer_hight", names), "layer_height_mm");
    EXPECT_EQ(nearest_name("Layer-Height", names), "layer_height_mm");
    EXPECT_EQ(nearest_name("fun", names), "fan");
    EXPECT_EQ(suggestion("wals", names), "; did you mean walls?");
}

TEST(NearestName, SaysNothingWhenNothingIsNear) {
    EXPECT_EQ(nearest_name("viscosity", names), "");
    EXPECT_EQ(nearest_name("", names), "");
    EXPECT_EQ(nearest_name(std::string(100000, 'w'), names), "");
    EXPECT_EQ(nearest_name("walls", {}), "");
    EXPECT_EQ(suggestion("viscosity", names), "");
}

RC_GTEST_PROP(NearestName, UndoesAnyOneMistake, ()) {
    const std::string name(names.at(*rc::gen::inRange<std::size_t>(0, names.size())));
    const auto place = *rc::gen::inRange<std::size_t>(0, name.size());
    std::string wrong = name;
    switch (*rc::gen::inRange(0, 3)) {
        case 0:
            wrong.erase(place, 1);
            break;
        case 1:
            wrong.insert(place, 1, 'q');
            break;
        default:
            wrong[place] = 'q';
    }
    RC_ASSERT(nearest_name(wrong, names) == name);
}

}  // namespace
}  // namespace bead
