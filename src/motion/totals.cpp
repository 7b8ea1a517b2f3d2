#include "motion/totals.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

bool moves_head(const Block& block) {
    return block.delta[axis_x] != 0 || block.delta[axis_y] != 0 || block.delta[axis_z] != 0;
}

LayerMotion& current_layer(MotionTotals& totals) {
    return totals.by_layer.empty() ? totals.before_layers : totals.by_layer.back();
}

void add_speeds(MotionTotals& totals, const Block& block) {
    totals.fastest = std::max(totals.fastest, block.v_peak);
    if (block.v_peak < block.v_nominal * (1 - 1e-9)) totals.short_of_speed += 1;
    for (std::size_t i = 0; i < block.delta.size(); ++i)
        if (std::abs(block.delta[i]) * block.v_peak > totals.fastest_axis[i] * block.length)
            totals.fastest_axis[i] = std::abs(block.delta[i]) * block.v_peak / block.length;
}

void add(MotionTotals& totals, const Block& block) {
    const double time = duration(block), e = block.delta[axis_e];
    RoleMotion& role = current_layer(totals).by_role[static_cast<std::size_t>(block.role)];
    totals.duration += time;
    totals.by_role[static_cast<std::size_t>(block.role)] += time;
    role.duration += time;
    totals.moves += 1;
    role.moves += 1;
    totals.filament += e;
    if (e < 0) totals.retractions += 1;
    add_speeds(totals, block);
    add(totals.axes, block);
    if (!moves_head(block)) return;
    totals.length += block.length;
    role.length += block.length;
    if (e > 0) {
        totals.extruded += e;
        role.extruded += e;
    } else {
        totals.travel += block.length;
        totals.travel_moves += 1;
    }
}

void add(MotionTotals& totals, const Dwell& dwell) {
    totals.duration += dwell.duration;
    totals.dwell += dwell.duration;
    current_layer(totals).dwell += dwell.duration;
    add(totals.axes, dwell);
}

void add_roles(PerRole<RoleMotion>& sum, const LayerMotion& layer) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = sum[i] + layer.by_role[i];
}

}  // namespace

RoleMotion operator+(const RoleMotion& a, const RoleMotion& b) {
    return {a.moves + b.moves, a.duration + b.duration, a.length + b.length,
            a.extruded + b.extruded};
}

RoleMotion total(const PerRole<RoleMotion>& by_role) {
    RoleMotion sum;
    for (const RoleMotion& role : by_role) sum = sum + role;
    return sum;
}

double duration(const LayerMotion& layer) { return total(layer.by_role).duration + layer.dwell; }

void add(MotionTotals& totals, const MotionEvent& event) {
    if (const Block* block = std::get_if<Block>(&event)) {
        add(totals, *block);
    } else if (const Dwell* dwell = std::get_if<Dwell>(&event)) {
        add(totals, *dwell);
    } else if (const LayerStart* layer = std::get_if<LayerStart>(&event)) {
        totals.by_layer.push_back({.z = layer->z, .height = layer->height, .by_role = {}});
    }
}

PerRole<RoleMotion> motion_by_role(const MotionTotals& totals) {
    PerRole<RoleMotion> sum{};
    add_roles(sum, totals.before_layers);
    for (const LayerMotion& layer : totals.by_layer) add_roles(sum, layer);
    return sum;
}

}  // namespace bead
