// Layers to a toolpath. `plan` does it all; the steps beside it are for those who choose pattern
// and angle layer by layer and do not want the rest computed again.
//
//     const std::vector<LayerParts> parts = parts_of(slices.layers, options);
//     const FillSpacing lines = matched_spacing(parts, options);
//     Toolpath layer = plan_layer(parts[7], {patterns[1], 0.0}, lines, options, start);
#pragma once
#include <array>
#include <span>

#include "plan/parts.h"

namespace bead {

// How the sparse infill of each pattern (in the order of `patterns`) is laid so that that of the
// whole part, links and curves included, deposits what the density asks for. One distance for all
// layers, so that lines stand on lines. Where no distance gives the volume (a ring takes one more
// concentric loop or not), the section of the bead is multiplied by `flow`.
struct FillSpacing {
    std::array<double, patterns.size()> by_pattern{};  // mm between lines; 0: spacing / density
    std::array<double, patterns.size()> flow{};        // 0 where by_pattern is 0
};
// The choice for one layer. Skin is always rectilinear, at `angle`; the pattern is that of the
// sparse infill. The angle is what the lines of this layer have: alternation is the caller's
// (layer_angle).
struct FillChoice {
    NamedPattern pattern = patterns[0];
    double angle = 0;
    double sparse_turn = 0;  // rad by which the sparse infill is turned further
};

// Of the `wanted` patterns, tried on layers from all of the part; the others keep 0, as do all
// where there is no sparse infill.
FillSpacing matched_spacing(std::span<const LayerParts> parts, const PlanOptions& options,
                            std::span<const NamedPattern> wanted = patterns);

// The same for layers whose patterns and angles are chosen already: each pattern is matched on the
// layers that have it.
FillSpacing matched_spacing(std::span<const LayerParts> parts, std::span<const FillChoice> choices,
                            const PlanOptions& options);

// PrusaSlicer's alternation: odd layers are turned by 90°.
double layer_angle(double angle, int layer_index);

// What the options say for a layer: the skin alternates, and the sparse infill with it unless its
// pattern would then not stand on itself.
FillChoice usual_choice(const PlanOptions& options, int layer_index);

// Everything printed in one layer, travel included, from where the nozzle stands; z of all points
// is the layer's. The first path is the travel to the layer (from `start`, at the layer's z).
Toolpath plan_layer(const LayerParts& parts, const FillChoice& choice, const FillSpacing& lines,
                    const PlanOptions& options, Vec2 start);

Toolpath plan(std::span<const Layer> layers, const PlanOptions& options);

// mm³ by what it is for: what the regions, walls and density ask for, and what a toolpath deposits.
struct Volumes {
    double wall = 0, skin = 0, infill = 0, support = 0, skirt = 0, other = 0;
};
Volumes asked_volumes(std::span<const LayerParts> parts, const PlanOptions& options);
Volumes deposited_volumes(const Toolpath& toolpath);
Volumes operator+(const Volumes& a, const Volumes& b);

}  // namespace bead
