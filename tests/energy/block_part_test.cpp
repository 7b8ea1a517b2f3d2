#include "energy/block_part.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "energy/motors.h"
#include "energy/published.h"
#include "support/any_print.h"

namespace bead {
namespace {

using namespace test;

RC_GTEST_PROP(BlockPart, PartsComeToTheWhole, ()) {
    const Block block = any_block();
    const double seconds = duration(block), cut = number_between(0, seconds);
    const Block first = part_of(block, 0, cut), second = part_of(block, cut, seconds);
    RC_ASSERT(near(duration(first) + duration(second), seconds));
    RC_ASSERT(near(first.length + second.length, block.length));
    for (std::size_t axis = 0; axis < 4; ++axis)
        RC_ASSERT(near(first.delta[axis] + second.delta[axis], block.delta[axis]));
    RC_ASSERT(first.v_exit == second.v_entry);
    const auto motors = desktop().motors;
    RC_ASSERT(near(total(motor_draw(motors, first)) + total(motor_draw(motors, second)),
                   total(motor_draw(motors, block))));
    const Features whole = features_of(block), sum = features_of(first) + features_of(second);
    RC_ASSERT(near(published_energy(sum), published_energy(whole)));
    RC_ASSERT(near(standing_form(sum), standing_form(whole)));
}

}  // namespace
}  // namespace bead
