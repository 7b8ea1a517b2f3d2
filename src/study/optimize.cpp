#include "study/optimize.h"

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

// Cheaper than the baseline, and not by printing less.
bool is_better(const Optimum& result, Goal goal) {
    return value_of(goal, result.chosen_cost) < value_of(goal, result.baseline_cost) &&
           result.chosen_cost.motion.extruded >=
               least_weight * result.baseline_cost.motion.extruded;
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
    Effort effort;
    result.rotation =
        options.rotation ? *options.rotation : best_rotation(parts, jury, weights, options, effort);
    tell(options.progress, 0.6, "choosing layer by layer");
    result.chosen = {on_bed(parts, result.rotation, machine.printer), {}, lines, plan, program};
    result.chosen.choices = best_choices(result.chosen.parts, jury, weights, options, effort);
    tell(options.progress, 0.9, "simulating the whole print");
    result.candidates = effort.candidates;
    result.evaluated = effort.evaluated;
    result.chosen_cost = assess(result.chosen, machine);
    if (!is_better(result, options.goal)) {
        result.chosen = result.baseline;
        result.chosen_cost = result.baseline_cost;
        result.rotation = options.baseline_rotation;
    }
    tell(options.progress, 1, "done");
    return result;
}

}  // namespace bead
