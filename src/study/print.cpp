#include "study/print.h"

#include <algorithm>

#include "core/expects.h"

namespace bead {
namespace {

Box2 footprint(std::span<const LayerParts> parts) {
    Box2 box;
    for (const LayerParts& layer : parts)
        for (const Island& island : layer.islands) box.include(bounds(island.outline.outer));
    return box;
}

// About X0 Y0.
bool fits_round_bed(const Box2& box, double diameter) {
    if (box.is_empty()) return true;
    const Vec2 farthest{std::max(-box.low.x, box.high.x), std::max(-box.low.y, box.high.y)};
    return length(farthest) <= diameter / 2;
}

}  // namespace

std::vector<LayerParts> on_bed(std::span<const LayerParts> parts, double rotation,
                               const Printer& printer) {
    const Vec2 middle = footprint(parts).centre();
    const Vec2 bed = middle_of_bed(printer);
    std::vector<LayerParts> placed;
    placed.reserve(parts.size());
    for (const LayerParts& layer : parts)
        placed.push_back(moved(layer, rotation, middle, bed - middle));
    return placed;
}

bool fits_bed(std::span<const LayerParts> parts, const Printer& printer) {
    Box2 box = footprint(parts);
    for (const LayerParts& layer : parts)
        for (const Polyline& loop : layer.skirt) box.include(bounds(loop));
    const double top = parts.empty() ? 0 : parts.back().z;
    const bool flat_fits = printer.kinematics == Kinematics::delta
                               ? fits_round_bed(box, printer.bed[0])
                               : box.low.x >= 0 && box.low.y >= 0 && box.high.x <= printer.bed[0] &&
                                     box.high.y <= printer.bed[1];
    return flat_fits && top <= printer.bed[2];
}

std::vector<FillChoice> uniform_choices(std::size_t layers, const PlanOptions& options) {
    std::vector<FillChoice> choices;
    for (std::size_t i = 0; i < layers; ++i)
        choices.push_back(usual_choice(options, static_cast<int>(i)));
    return choices;
}

void run(const Print& print, const CommandSink& sink, const LayerSink& layers) {
    BEAD_EXPECTS(print.choices.size() == print.parts.size());
    std::vector<Command> commands;
    const auto pour = [&] {
        for (const Command& command : commands) sink(command);
        commands.clear();
    };
    Nozzle nozzle;
    append_start(commands, nozzle, print.program);
    pour();
    for (std::size_t i = 0; i < print.parts.size(); ++i) {
        const LayerParts& parts = print.parts[i];
        const Toolpath layer = plan_layer(parts, print.choices[i], print.lines, print.plan,
                                          {nozzle.at[axis_x], nozzle.at[axis_y]});
        append_layer(commands, layer, parts.z, parts.height, parts.index, nozzle, print.program);
        pour();
        if (layers) layers(i, layer);
    }
    append_end(commands, nozzle, print.program);
    pour();
}

}  // namespace bead
