// All blocks that the planner makes of a stream of commands, and what they sum to.
#pragma once
#include <vector>

#include "motion/planner.h"

namespace bead::test {

// `feed(sink)` gives the commands.
template <class Feed>
std::vector<Block> planned(const Limits& limits, const PlannerOptions& options, const Feed& feed) {
    std::vector<Block> blocks;
    const auto planner = make_planner(limits, options, [&](const MotionEvent& event) {
        if (const Block* block = std::get_if<Block>(&event)) blocks.push_back(*block);
    });
    feed([&](const Command& command) { planner->add(command); });
    planner->finish();
    return blocks;
}

inline double total_time(const std::vector<Block>& blocks) {
    double sum = 0;
    for (const Block& block : blocks) sum += duration(block);
    return sum;
}

}  // namespace bead::test
