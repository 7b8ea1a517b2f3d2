#include "motion/totals.h"

#include <algorithm>

namespace bead {
namespace {

bool moves_head(const Block& block) {
    return block.delta[axis_x] != 0 || block.delta[axis_y] != 0 || block.delta[axis_z] != 0;
}

void add(MotionTotals& totals, const Block& block) {
    const double time = duration(block), e = block.delta[axis_e];
    totals.duration += time;
    totals.by_role[static_cast<std::size_t>(block.role)] += time;
    totals.moves += 1;
    totals.filament += e;
    totals.fastest = std::max(totals.fastest, block.v_peak);
    if (block.v_peak < block.v_nominal * (1 - 1e-9)) totals.short_of_speed += 1;
    if (e < 0) totals.retractions += 1;
    add(totals.axes, block);
    if (!moves_head(block)) return;
    totals.length += block.length;
    if (e > 0) {
        totals.extruded += e;
    } else {
        totals.travel += block.length;
        totals.travel_moves += 1;
    }
}

}  // namespace

void add(MotionTotals& totals, const MotionEvent& event) {
    if (const Block* block = std::get_if<Block>(&event)) {
        add(totals, *block);
    } else if (const Dwell* dwell = std::get_if<Dwell>(&event)) {
        totals.duration += dwell->duration;
        totals.dwell += dwell->duration;
        add(totals.axes, *dwell);
    }
}

}  // namespace bead
