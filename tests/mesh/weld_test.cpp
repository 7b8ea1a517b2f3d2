#include "mesh/weld.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <map>
#include <tuple>

namespace bead {
namespace {

RC_GTEST_PROP(weld, agrees_with_a_map,
              (const std::vector<std::tuple<std::int8_t, bool>>& corners)) {
    std::map<std::tuple<double, double>, int> seen;
    Welder welder(0);
    for (const auto& [x, y] : corners) {
        const auto fresh = static_cast<int>(seen.size());
        const int expected = seen.try_emplace({x, y}, fresh).first->second;
        RC_ASSERT(welder.index({x * 1.0, y * 1.0, 0}) == expected);
    }
    RC_ASSERT(std::move(welder).points().size() == seen.size());
}

TEST(weld, zero_has_no_sign_and_what_is_no_number_ends_the_search) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Welder welder(4);
    EXPECT_EQ(welder.index({0, 0, 0}), welder.index({-0.0, 0, -0.0}));
    EXPECT_EQ(welder.index({nan, 0, 0}), welder.index({nan, 0, 0}));
}

}  // namespace
}  // namespace bead
