#include "study/optimize.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "core/parallel.h"
#include "search/chain.h"
#include "study/layer_cost.h"

namespace bead {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::size_t sampled_layers = 10;  // classes of layers by which rotations are compared

// Angle between two families of lines, 0 … pi/2.
double crossing(double a, double b) {
    const double turn = std::fmod(std::abs(a - b), pi);
    return std::min(turn, pi - turn);
}

std::vector<double> steps_up_to(double end, double step) {
    std::vector<double> values;
    const auto count = std::max(1, static_cast<int>(std::lround(end / step)));
    for (int i = 0; i < count; ++i) values.push_back(end * i / count);
    return values;
}

std::vector<FillChoice> all_choices(const OptimizeOptions& options, double angle_step) {
    std::vector<FillChoice> choices;
    for (const NamedPattern& pattern : options.patterns)
        for (const double angle : steps_up_to(pi, angle_step)) choices.push_back({pattern, angle});
    return choices;
}

// The classes that stand for most layers, in the order of the layers.
std::vector<LayerClass> most_common(std::vector<LayerClass> classes) {
    std::ranges::stable_sort(classes, std::greater{},
                             [](const LayerClass& c) { return c.members.size(); });
    if (classes.size() > sampled_layers) {  // every n-th keeps both the common and the odd ones
        std::vector<LayerClass> spread;
        for (std::size_t i = 0; i < sampled_layers; ++i)
            spread.push_back(classes[i * classes.size() / sampled_layers]);
        classes = std::move(spread);
    }
    return classes;
}

// One row per class, one column per choice; `never` where another choice gives the same.
std::vector<std::vector<double>> class_costs(std::span<const LayerParts> parts,
                                             std::span<const LayerClass> classes,
                                             std::span<const FillChoice> choices, const Jury& jury,
                                             const OptimizeOptions& options, long& evaluated) {
    std::vector<std::vector<double>> costs(classes.size(),
                                           std::vector<double>(choices.size(), never));
    std::vector<std::pair<std::size_t, std::size_t>> jobs;
    for (std::size_t c = 0; c < classes.size(); ++c)
        for (std::size_t i = 0; i < choices.size(); ++i)
            if (is_distinct(parts[classes[c].example], choices[i])) jobs.emplace_back(c, i);
    parallel_for(jobs.size(), options.threads, [&](std::size_t job) {
        const auto [c, i] = jobs[job];
        costs[c][i] = layer_cost(parts[classes[c].example], choices[i], jury);
    });
    evaluated += static_cast<long>(jobs.size());
    return costs;
}

// The least that the sampled layers can cost when lines alternate by a right angle.
double rotation_cost(const std::vector<std::vector<double>>& costs,
                     std::span<const LayerClass> classes, std::span<const LayerParts> parts,
                     std::span<const FillChoice> choices) {
    double sum = 0;
    for (std::size_t c = 0; c < classes.size(); ++c) {
        double least = never;
        for (std::size_t i = 0; i < choices.size(); ++i) {
            double cost = costs[c][i];
            if (has_direction(parts[classes[c].example], choices[i].pattern))
                for (std::size_t k = 0; k < choices.size(); ++k)
                    if (choices[k].pattern.name == choices[i].pattern.name && costs[c][k] < never &&
                        crossing(choices[k].angle, choices[i].angle) > pi / 2 - 1e-6)
                        cost = (costs[c][i] + costs[c][k]) / 2;
            least = std::min(least, cost);
        }
        sum += least * static_cast<double>(classes[c].members.size());
    }
    return sum;
}

// Best of the rotations on a coarse grid, then between its neighbours at half the step.
double best_rotation(std::span<const LayerParts> parts, const Jury& jury,
                     const OptimizeOptions& options, long& candidates, long& evaluated) {
    const std::vector<LayerClass> classes = most_common(alike_layers(parts));
    const std::vector<FillChoice> choices = all_choices(options, pi / 4);
    double best = 0, least = never;
    const auto attempt = [&](double rotation) {
        const std::vector<LayerParts> placed = on_bed(parts, rotation, jury.machine.printer);
        if (!fits_bed(placed, jury.machine.printer)) return;
        candidates += static_cast<long>(choices.size());
        const auto costs = class_costs(placed, classes, choices, jury, options, evaluated);
        const double cost = rotation_cost(costs, classes, placed, choices);
        if (cost < least) {
            least = cost;
            best = rotation;
        }
    };
    const std::vector<double> coarse = steps_up_to(pi, options.rotation_step);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        tell(options.progress, 0.5 * static_cast<double>(i) / static_cast<double>(coarse.size()),
             "turning the part");
        attempt(coarse[i]);
    }
    const double centre = best;
    for (const double side : {-0.5, 0.5}) attempt(centre + side * options.rotation_step);
    return best;
}

// For every layer the choice that makes the whole cheapest while neighbouring lines cross.
std::vector<FillChoice> best_choices(std::span<const LayerParts> placed, const Jury& jury,
                                     const OptimizeOptions& options, long& candidates,
                                     long& evaluated) {
    const std::vector<LayerClass> classes = alike_layers(placed);
    const std::vector<FillChoice> choices = all_choices(options, options.angle_step);
    candidates += static_cast<long>(choices.size());
    const auto costs = class_costs(placed, classes, choices, jury, options, evaluated);
    std::vector<std::vector<double>> by_layer(placed.size());
    for (std::size_t c = 0; c < classes.size(); ++c)
        for (const std::size_t layer : classes[c].members) by_layer[layer] = costs[c];
    const auto lines_cross = [&](std::size_t step, std::size_t from, std::size_t to) {
        return !has_direction(placed[step - 1], choices[from].pattern) ||
               !has_direction(placed[step], choices[to].pattern) ||
               crossing(choices[from].angle, choices[to].angle) >= options.least_crossing - 1e-9;
    };
    const std::optional<Chain> chain = cheapest_chain(by_layer, lines_cross);
    std::vector<FillChoice> chosen;
    if (chain)
        for (const std::size_t i : chain->choices) chosen.push_back(choices[i]);
    return chosen;
}

Assessment assess(const Print& print, const Machine& machine) {
    Judge judge(machine);
    run(print, [&](const Command& command) { judge.add(command); });
    return judge.finish();
}

}  // namespace

double value_of(Goal goal, const Assessment& assessment) {
    switch (goal) {
        case Goal::machine_energy:
            return total(assessment.energy.energy) - assessment.energy.heat_up;
        case Goal::xy_energy:
            return standing_form(assessment.features);
        case Goal::time:
            return assessment.motion.duration;
    }
    return 0;
}

Optimum optimize(std::span<const LayerParts> parts, const PlanOptions& plan,
                 const ProgramOptions& program, const Machine& machine,
                 const OptimizeOptions& options) {
    const FillSpacing lines = matched_spacing(parts, plan);
    const Jury jury{machine, plan, program, lines, options.goal};
    Optimum result;
    result.baseline_rotation = options.baseline_rotation;
    result.baseline = {on_bed(parts, options.baseline_rotation, machine.printer),
                       uniform_choices(parts.size(), plan), lines, plan, program};
    if (!fits_bed(result.baseline.parts, machine.printer) && options.rotation)
        throw Error(
            "the part does not fit the bed at this rotation; leave out --rotate or choose another "
            "printer",
            Fault::infeasible);
    result.baseline_cost = assess(result.baseline, machine);

    result.rotation =
        options.rotation ? *options.rotation
                         : best_rotation(parts, jury, options, result.candidates, result.evaluated);
    tell(options.progress, 0.6, "choosing layer by layer");
    result.chosen = {on_bed(parts, result.rotation, machine.printer), {}, lines, plan, program};
    result.chosen.choices =
        best_choices(result.chosen.parts, jury, options, result.candidates, result.evaluated);
    tell(options.progress, 0.9, "simulating the whole print");
    if (result.chosen.choices.size() == parts.size())
        result.chosen_cost = assess(result.chosen, machine);
    if (result.chosen.choices.size() != parts.size() ||
        value_of(options.goal, result.chosen_cost) >=
            value_of(options.goal, result.baseline_cost)) {
        result.chosen = result.baseline;
        result.chosen_cost = result.baseline_cost;
        result.rotation = options.baseline_rotation;
    }
    tell(options.progress, 1, "done");
    return result;
}

}  // namespace bead
