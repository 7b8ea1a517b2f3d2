#include "vibration/rms_over_time.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

namespace bead {
namespace {

RC_GTEST_PROP(RmsOverTime, keeps_all_squares_in_few_windows, ()) {
    const auto count = *rc::gen::inRange<std::size_t>(1, 5000);
    const auto most = *rc::gen::inRange<std::size_t>(2, 40);
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::normal_distribution<double> normal;
    RmsOverTime over_time(0.01, most);
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 a{normal(random), normal(random)};
        squares += dot(a, a);
        over_time.add(a);
    }
    const std::vector<RmsWindow> windows = over_time.windows();
    RC_ASSERT(windows.size() <= most && 2 * windows.size() >= std::min(count, most));
    RC_ASSERT(windows.front().from == 0);
    RC_ASSERT(std::abs(windows.back().to - 0.01 * double(count)) < 1e-9);
    double kept = 0;
    for (std::size_t i = 0; i < windows.size(); ++i) {
        if (i > 0) RC_ASSERT(windows[i].from == windows[i - 1].to);
        kept += windows[i].rms * windows[i].rms * (windows[i].to - windows[i].from) / 0.01;
    }
    RC_ASSERT(std::abs(kept - squares) < 1e-9 * squares);
}

TEST(RmsOverTime, TellsTheQuietHalfFromTheLoud) {
    RmsOverTime over_time(0.001, 64);
    for (int i = 0; i < 4096; ++i) over_time.add({i < 2048 ? 1.0 : 3.0, 0});
    for (const RmsWindow& window : over_time.windows())
        EXPECT_DOUBLE_EQ(window.rms, window.to < 2.0481 ? 1 : 3);
}

}  // namespace
}  // namespace bead
