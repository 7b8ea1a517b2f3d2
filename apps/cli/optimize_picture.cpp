#include "optimize_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>

#include "console.h"
#include "core/output_file.h"
#include "scene/layer_picture.h"

namespace bead::cli {
namespace {

double sparse_area(const LayerParts& layer) {
    double sum = 0;
    for (const Island& island : layer.islands)
        for (const FillArea& fill : island.fills)
            if (fill.role == Role::infill) sum += area(fill.material);
    return sum;
}

// Of the layers with much infill, the one that saves most nearly what the whole print saves:
// neither the best nor the worst of them stands for the rest.
std::size_t telling_layer(const Optimum& best) {
    const std::vector<LayerParts>& parts = best.chosen.print.parts;
    double most = 0;
    for (const LayerParts& layer : parts) most = std::max(most, sparse_area(layer));
    const auto change = [](double before, double after) { return after / before - 1; };
    const double whole =
        change(best.baseline.cost.motion.duration, best.chosen.cost.motion.duration);
    std::size_t telling = parts.size() / 2;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (sparse_area(parts[i]) < most / 2) continue;
        const double off = change(best.baseline.cost.energy.by_layer.at(i).duration,
                                  best.chosen.cost.energy.by_layer.at(i).duration) -
                           whole;
        if (std::abs(off) >= least) continue;
        least = std::abs(off);
        telling = i;
    }
    return telling;
}

Toolpath toolpath_of(const Print& print, std::size_t layer) {
    return plan_layer(print.parts[layer], print.choices[layer], print.lines, print.plan,
                      {print.parts[layer].centre});
}

Panel panel(const std::string& title, const JudgedPrint& judged, std::size_t layer) {
    const LayerEnergy& energy = judged.cost.energy.by_layer.at(layer);
    return {title, toolpath_of(judged.print, layer),
            fmt::format("this layer: {}, {:.2f} Wh", spoken_time(energy.duration),
                        energy.total / 3600)};
}

}  // namespace

void write_picture(const std::string& file, const Optimum& best) {
    const std::size_t layer = telling_layer(best);
    const std::array panels{panel("before", best.baseline, layer),
                            panel("after", best.chosen, layer)};
    OutputFile out(file);
    out.stream() << layer_picture(
        panels, fmt::format("Layer {} of {}, z = {:.2f} mm", layer + 1,
                            best.chosen.print.parts.size(), best.chosen.print.parts[layer].z));
    out.keep();
}

}  // namespace bead::cli
