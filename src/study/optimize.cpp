#include "study/optimize.h"

#include <algorithm>

#include "core/error.h"
#include "study/choose_layers.h"
#include "study/choose_rotation.h"

namespace bead {
namespace {

Assessment assess(const Print& print, const Machine& machine) {
    Judge judge(machine);
    run(print, [&](const Command& command) { judge.add(command); });
    return judge.finish();
}

constexpr std::size_t tried_whole = 3;  // rotations for which the whole print is planned

// Cheaper, and not by printing less.
bool is_better(const Assessment& cost, const Optimum& than, Goal goal) {
    return value_of(goal, cost) < value_of(goal, than.chosen_cost) &&
           cost.motion.extruded >= least_weight * than.baseline_cost.motion.extruded;
}

std::vector<double> rotations_to_try(std::span<const LayerParts> parts, const Jury& jury,
                                     const Weights& weights, const OptimizeOptions& options,
                                     Effort& effort) {
    if (options.rotation) return {*options.rotation};
    std::vector<double> rotations =
        promising_rotations(parts, jury, weights, options, tried_whole, effort);
    if (std::ranges::find(rotations, options.baseline_rotation) == rotations.end())
        rotations.push_back(options.baseline_rotation);
    return rotations;
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
    if (!fits_bed(result.baseline.parts, machine.printer))
        throw Error("the part does not fit the bed of " + machine.printer.name +
                        "; turn it (--rotate) or choose another printer",
                    Fault::infeasible);
    result.baseline_cost = assess(result.baseline, machine);

    const Weights weights{
        value_of(options.goal, result.baseline_cost) / result.baseline_cost.motion.extruded,
        result.baseline_cost.motion.extruded};
    result.chosen = result.baseline;
    result.chosen_cost = result.baseline_cost;
    result.rotation = options.baseline_rotation;
    Effort effort;
    const std::vector<double> rotations = rotations_to_try(parts, jury, weights, options, effort);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        tell(options.progress,
             0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(rotations.size()),
             "choosing layer by layer");
        Print print{on_bed(parts, rotations[i], machine.printer), {}, lines, plan, program};
        print.choices = best_choices(print.parts, jury, weights, options, effort);
        const Assessment cost = assess(print, machine);
        if (!is_better(cost, result, options.goal)) continue;
        result.chosen = std::move(print);
        result.chosen_cost = cost;
        result.rotation = rotations[i];
    }
    result.candidates = effort.candidates;
    result.evaluated = effort.evaluated;
    tell(options.progress, 1, "done");
    return result;
}

}  // namespace bead
