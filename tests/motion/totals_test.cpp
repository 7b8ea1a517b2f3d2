#include "motion/totals.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "motion/planner.h"
#include "support/commands.h"

namespace bead {
namespace {

bool nearly(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(a)); }

RC_GTEST_PROP(MotionTotals, of_layers_and_roles_add_up_to_those_of_the_print, ()) {
    const std::vector<Command> commands = stream_of(*stream_plans());
    MotionTotals totals;
    double top = 0;
    PerAxis<double> top_axis{};
    std::size_t layers = 0;
    const auto planner = make_planner({}, {}, [&](const MotionEvent& event) {
        add(totals, event);
        layers += std::holds_alternative<LayerStart>(event) ? 1 : 0;
        const Block* const block = std::get_if<Block>(&event);
        if (!block) return;
        top = std::max(top, block->v_peak);
        for (std::size_t i = 0; i < 4; ++i)
            top_axis[i] =
                std::max(top_axis[i], std::abs(block->delta[i]) / block->length * block->v_peak);
    });
    for (const Command& command : commands) planner->add(command);
    planner->finish();

    double time = duration(totals.before_layers), dwell = totals.before_layers.dwell;
    for (const LayerMotion& layer : totals.by_layer) {
        time += duration(layer);
        dwell += layer.dwell;
    }
    const PerRole<RoleMotion> roles = motion_by_role(totals);
    const RoleMotion all = total(roles);
    RC_ASSERT(totals.by_layer.size() == layers);
    RC_ASSERT(nearly(time, totals.duration));
    RC_ASSERT(nearly(dwell, totals.dwell));
    RC_ASSERT(nearly(all.duration + dwell, totals.duration));
    RC_ASSERT(nearly(all.length, totals.length));
    RC_ASSERT(nearly(all.extruded, totals.extruded));
    RC_ASSERT(all.moves == totals.moves);
    for (std::size_t i = 0; i < roles.size(); ++i)
        RC_ASSERT(nearly(roles[i].duration, totals.by_role[i]));
    RC_ASSERT(totals.fastest == top);
    for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(nearly(totals.fastest_axis[i], top_axis[i]));
}

}  // namespace
}  // namespace bead
