#include "smooth/chain.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "smooth/order.h"
#include "smooth/wall_chain.h"
#include "support/blocks.h"
#include "support/smooth_layers.h"

using namespace bead;
using namespace bead::test;

namespace {

Ring circle(Vec2 centre, double radius, double section) {
    const Polyline loop = round_loop(centre, radius, 720);
    return ring_of(loop, std::vector(loop.size(), Flow{section, 50, Role::wall, 0}));
}

Chain nested(Vec2 centre, double radius, int loops) {
    std::vector<Ring> rings;
    std::vector<std::size_t> lanes;
    for (int i = 0; i < loops; ++i) {
        rings.push_back(circle(centre, radius + 0.4 * i, 0.08));
        lanes.push_back(static_cast<std::size_t>(i));
    }
    return wall_chain(lanes, rings, {});
}

}  // namespace

// As long as its loops and one link, with their volume, whatever the seam and the direction.
RC_GTEST_PROP(Chain, WallsAreWoundWithoutMoreOrLess, ()) {
    const int loops = *rc::gen::inRange(1, 5);
    const Chain chain = nested({3, 4}, number_between(5, 30), loops);
    const auto pick = static_cast<std::size_t>(*rc::gen::inRange(0, 128));
    const Ribbon ribbon = wound(chain, chain.windings[pick]);
    double all = 0;
    for (const Ring& ring : chain.rings) all += ring.length;
    const double link = loops > 1 ? chain.link : 0;
    RC_ASSERT(std::abs(length(ribbon) - all - link) < 0.02 * (all + link) / 10);
    RC_ASSERT(std::abs(volume(ribbon) / (0.08 * all) - 1) < 5e-3);
    RC_ASSERT(distance(ribbon.points.front(), chain.windings[pick].in.at) < 1e-6);
    RC_ASSERT(distance(ribbon.points.back(), chain.windings[pick].out.at) < 1e-6);
}

// The outermost loop is closed at full flow before anything else.
TEST(Chain, BeginsWithTheWholeOuterLoop) {
    const Chain chain = nested({}, 10, 3);
    const Ribbon ribbon = wound(chain, chain.windings[5]);
    double full = 0;
    for (std::size_t i = 0; full < chain.rings[0].length - 1e-6; ++i) {
        EXPECT_NEAR(length(ribbon.points[i]), 10, 1e-3);
        EXPECT_DOUBLE_EQ(ribbon.flows[i].section, 0.08);
        full += distance(ribbon.points[i], ribbon.points[i + 1]);
    }
}

TEST(Chain, WallsTurnNowhereSharply) {
    const Chain chain = nested({}, 6, 4);
    for (const Winding& winding : chain.windings) {
        const Ribbon ribbon = wound(chain, winding);
        for (std::size_t i = 1; i + 1 < ribbon.points.size(); ++i) {
            const Vec2 in = ribbon.points[i] - ribbon.points[i - 1];
            const Vec2 out = ribbon.points[i + 1] - ribbon.points[i];
            EXPECT_GT(dot(in, out), std::cos(0.15) * length(in) * length(out));
        }
    }
}

RC_GTEST_PROP(Order, HasEveryStrokeOnceAndPhasesInTheirOrder, ()) {
    std::vector<Chain> chains;
    std::vector<int> phases;
    const int count = *rc::gen::inRange(1, 25);
    for (int i = 0; i < count; ++i) {
        const Vec2 at{number_between(0, 200), number_between(0, 200)};
        if (i % 3 == 0)
            chains.push_back(nested(at, 6, 2));
        else
            chains.push_back(line_chain(0, {{at, at + Vec2{5, 1}}, {Flow{}}}, i % 3 == 1));
        phases.push_back(i * 3 / count);
    }
    const std::vector<OrderedStroke> order = ordered(chains, phases, {}, {});
    std::vector<int> seen(chains.size(), 0);
    int phase = 0;
    for (const OrderedStroke& stroke : order) {
        ++seen[stroke.chain];
        RC_ASSERT(stroke.winding < chains[stroke.chain].windings.size());
        RC_ASSERT(phases[stroke.chain] >= phase);
        phase = phases[stroke.chain];
    }
    RC_ASSERT(seen == std::vector<int>(chains.size(), 1));
}

// The cost is that of the path, or of going straight and stopping.
RC_GTEST_PROP(Travel, CostsItsLength, ()) {
    const auto any_end = [] {
        return StrokeEnd{{number_between(-30, 30), number_between(-30, 30)},
                         unit(number_between(-3, 3))};
    };
    const StrokeEnd from = any_end(), to = any_end();
    const TravelLine line = travel_line(from, to, 2);
    const double cost = travel_cost(from, to, 2);
    RC_ASSERT(distance(line.points.front(), from.at) < 1e-9);
    RC_ASSERT(distance(line.points.back(), to.at) < 1e-9);
    if (line.straight) {
        RC_ASSERT(cost >= distance(from.at, to.at) - 1e-9);
    } else {
        RC_ASSERT(std::abs(cost - length(line.points)) < 0.01 * cost);
    }
}
