#include "study/choose_layers.h"

#include "core/expects.h"
#include "search/chain.h"

namespace bead {
namespace {

constexpr double highest_price = 8;  // of plastic, in units of what the baseline pays for it
constexpr int price_steps = 12;      // halvings between too light and heavy enough

struct Layers {
    std::span<const LayerParts> parts;
    std::span<const FillChoice> choices;
    std::vector<const std::vector<LayerCost>*> costs;  // per layer, per choice
    double least_crossing = 0;
};

Chain cheapest_at(const Layers& layers, double price) {
    std::vector<std::vector<double>> costs;
    for (const std::vector<LayerCost>* row : layers.costs) {
        costs.emplace_back();
        for (const LayerCost& cost : *row)
            costs.back().push_back(cost.value - price * cost.filament);
    }
    const auto lines_cross = [&](std::size_t step, std::size_t from, std::size_t to) {
        return !has_direction(layers.parts[step - 1], layers.choices[from].pattern) ||
               !has_direction(layers.parts[step], layers.choices[to].pattern) ||
               crossing(layers.choices[from].angle, layers.choices[to].angle) >=
                   layers.least_crossing - 1e-9;
    };
    const std::optional<Chain> chain = cheapest_chain(costs, lines_cross);
    BEAD_EXPECTS(chain.has_value());  // every angle has one that crosses it
    return *chain;
}

double filament_of(const Layers& layers, const Chain& chain) {
    double sum = 0;
    for (std::size_t i = 0; i < chain.choices.size(); ++i)
        sum += (*layers.costs[i])[chain.choices[i]].filament;
    return sum;
}

Chain cheapest_of_weight(const Layers& layers, const Weights& weights) {
    Chain best = cheapest_at(layers, 0);
    if (filament_of(layers, best) >= weights.filament) return best;
    double light = 0, heavy = highest_price * weights.per_filament;
    best = cheapest_at(layers, heavy);
    for (int i = 0; i < price_steps; ++i) {
        const double price = (light + heavy) / 2;
        const Chain chain = cheapest_at(layers, price);
        if (filament_of(layers, chain) >= weights.filament) {
            heavy = price;
            best = chain;
        } else {
            light = price;
        }
    }
    return best;
}

}  // namespace

std::vector<FillChoice> best_choices(std::span<const LayerParts> placed, const Jury& jury,
                                     const Weights& weights, const OptimizeOptions& options,
                                     Effort& effort) {
    const std::vector<LayerClass> classes = alike_layers(placed);
    const std::vector<FillChoice> choices = all_choices(options.patterns, options.angle_step);
    const CostTable costs = class_costs(placed, classes, choices, jury, options.threads, effort);
    Layers layers{placed, choices, {}, options.least_crossing};
    layers.costs.resize(placed.size());
    for (std::size_t c = 0; c < classes.size(); ++c)
        for (const std::size_t layer : classes[c].members) layers.costs[layer] = &costs[c];
    std::vector<FillChoice> chosen;
    for (const std::size_t i : cheapest_of_weight(layers, weights).choices)
        chosen.push_back(choices[i]);
    return chosen;
}

}  // namespace bead
