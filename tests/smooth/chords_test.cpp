#include "smooth/chords.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "smooth/round_corners.h"
#include "support/blocks.h"
#include "support/smooth_layers.h"

using namespace bead;
using namespace bead::test;

namespace {

Ribbon ribbon_of(Polyline line, Role role) {
    std::vector<Flow> flows(line.size() - 1, Flow{0.08, 50, role, 0});
    return {std::move(line), std::move(flows)};
}

Polyline any_line() {
    Polyline line{{0, 0}};
    const int count = *rc::gen::inRange(2, 12);
    for (int i = 0; i < count; ++i)
        line.push_back(line.back() + number_between(0.3, 20) * unit(number_between(-3.1, 3.1)));
    return line;
}

}  // namespace

RC_GTEST_PROP(RoundCorners, StayWithinTheirTolerance, ()) {
    const Ribbon before = ribbon_of(any_line(), Role::outer_wall);
    const RoundedRibbon after = rounded(before, {});
    RC_ASSERT(deviation(after.ribbon.points, before.points, 0.02) < 0.0501);
    RC_ASSERT(deviation(before.points, after.ribbon.points, 0.02) < 0.0501);
    RC_ASSERT(length(after.ribbon) <= length(before) + 1e-9);
    RC_ASSERT(after.ribbon.points.front() == before.points.front());
    RC_ASSERT(after.ribbon.points.back() == before.points.back());
    RC_ASSERT(after.ribbon.flows.size() + 1 == after.ribbon.points.size());
}

RC_GTEST_PROP(Chords, StayNearTheLine, ()) {
    const Ribbon before = rounded(ribbon_of(any_line(), Role::wall), {}).ribbon;
    const Ribbon after = chorded(measured(before), {});
    RC_ASSERT(deviation(after.points, before.points, 0.02) < 0.051);
    RC_ASSERT(after.points.size() <= before.points.size());
    RC_ASSERT(after.points.back() == before.points.back());
}

// Neither smaller nor larger than the circle, and its chords push well above the modes.
TEST(Chords, KeepACirclesAreaAndLeaveTheModes) {
    for (const double radius : {4.2, 17.2, 60.0}) {
        Polyline loop = round_loop({}, radius, 2000);
        loop.push_back(loop.front());
        const ChordOptions options;
        const Ribbon after = chorded(measured(ribbon_of(loop, Role::wall)), options);
        Polyline chords(after.points.begin(), after.points.end() - 1);
        EXPECT_NEAR(signed_area(chords) / (pi * radius * radius), 1, 2e-3 / radius);
        if (radius > 30) continue;  // gentle enough not to matter
        const double chord = distance(after.points[3], after.points[4]);
        EXPECT_GT(50 / chord, 1.2 * options.frequency);
    }
}
