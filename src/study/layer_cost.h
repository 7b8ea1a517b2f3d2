// What one layer costs by itself, for choosing between ways to fill it: planned, made into
// commands, simulated from a standstill in the middle of the bed with everything warm, and charged.
#pragma once
#include "study/judge.h"
#include "study/optimize.h"
#include "study/print.h"

namespace bead {

// How layers are judged: all that does not change between candidates.
struct Jury {
    const Machine& machine;
    const PlanOptions& plan;
    const ProgramOptions& program;
    const FillSpacing& lines;
    Goal goal = Goal::machine_energy;
};

// In the unit of value_of(goal), at the weight that was asked for: `jury.lines` suit the part as a
// whole, but on a single layer one choice deposits a little more infill than another. What the
// infill costs is scaled to what it should weigh, else the cheapest choice would be the one that
// prints least.
double layer_cost(const LayerParts& layer, const FillChoice& choice, const Jury& jury);

// Layers that are the same but for their height above the bed are judged once.
struct LayerClass {
    std::size_t example = 0;           // the first of them
    std::vector<std::size_t> members;  // all of them, rising
};
std::vector<LayerClass> alike_layers(std::span<const LayerParts> parts);

// Whether the layer has lines that run mostly one way when it is filled like this.
bool has_direction(const LayerParts& layer, const NamedPattern& pattern);

// Whether the choice is worth trying on this layer, or one with a smaller angle or, where nothing
// is sparse, with the `first` of the allowed patterns gives the same.
bool is_distinct(const LayerParts& layer, const FillChoice& choice, const NamedPattern& first);

}  // namespace bead
