// A print as it will be made: the parts of its layers in their place on the bed, and for each layer
// what it is filled with. Its commands come layer by layer, so memory is bounded by the layer.
#pragma once
#include <vector>

#include "machine/printer.h"
#include "plan/plan.h"
#include "plan/program.h"

namespace bead {

struct Print {
    std::vector<LayerParts> parts;
    std::vector<FillChoice> choices;  // one per layer
    FillSpacing lines;
    PlanOptions plan;
    ProgramOptions program;
};

// The layers turned by `rotation` (rad) about the part's middle, which then stands in the middle of
// the bed.
std::vector<LayerParts> on_bed(std::span<const LayerParts> parts, double rotation,
                               const Printer& printer);

// Whether all of it, skirt included, lies within the bed and below its height.
bool fits_bed(std::span<const LayerParts> parts, const Printer& printer);

// The same pattern everywhere, its angle alternating from layer to layer.
std::vector<FillChoice> uniform_choices(std::size_t layers, const PlanOptions& options);

// From heating to switching off. `layers`, if given, sees each layer's toolpath too.
using LayerSink = std::function<void(std::size_t index, const Toolpath& layer)>;
void run(const Print& print, const CommandSink& sink, const LayerSink& layers = {});

}  // namespace bead
