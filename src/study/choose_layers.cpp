#include "study/choose_layers.h"

#include "core/expects.h"
#include "search/chain.h"

namespace bead {

std::vector<FillChoice> best_choices(std::span<const LayerParts> placed, const Jury& jury,
                                     const OptimizeOptions& options, Effort& effort) {
    const std::vector<LayerClass> classes = alike_layers(placed);
    const std::vector<FillChoice> choices = all_choices(options.patterns, options.angle_step);
    const CostTable costs = class_costs(placed, classes, choices, jury, options.threads, effort);
    std::vector<std::vector<double>> by_layer(placed.size());
    for (std::size_t c = 0; c < classes.size(); ++c)
        for (const std::size_t layer : classes[c].members) by_layer[layer] = costs[c];

    const auto lines_cross = [&](std::size_t step, std::size_t from, std::size_t to) {
        return !has_direction(placed[step - 1], choices[from].pattern) ||
               !has_direction(placed[step], choices[to].pattern) ||
               crossing(choices[from].angle, choices[to].angle) >= options.least_crossing - 1e-9;
    };
    const std::optional<Chain> chain = cheapest_chain(by_layer, lines_cross);
    BEAD_EXPECTS(chain.has_value());  // every angle has one that crosses it
    std::vector<FillChoice> chosen;
    for (const std::size_t i : chain->choices) chosen.push_back(choices[i]);
    return chosen;
}

}  // namespace bead
