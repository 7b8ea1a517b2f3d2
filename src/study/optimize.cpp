#include "study/optimize.h"

#include <algorithm>

#include "core/error.h"
#include "study/choose_layers.h"
#include "study/choose_rotation.h"

namespace bead {
namespace {

// With the infill's lines spaced so that this very print has the weight that was asked for.
JudgedPrint judged(Print print, double rotation, const Machine& machine) {
    print.lines = matched_spacing(print.parts, print.choices, print.plan);
    Judge judge(machine);
    run(print, [&](const Command& command) { judge.add(command); });
    return {std::move(print), rotation, judge.finish()};
}

// Pattern and angle alternating, as told, at `angle`.
Print uniform(Print print, double angle) {
    PlanOptions plan = print.plan;
    plan.angle = angle;
    print.choices = uniform_choices(print.parts.size(), plan);
    return print;
}

constexpr double least_weight =
    0.998;  // of the baseline's filament; below, a print counts as printing less
constexpr std::size_t tried_whole = 3;  // rotations for which the whole print is planned

// Takes the print if it is cheaper, and not by printing less.
void consider(JudgedPrint print, Optimum& result, Goal goal) {
    const double least = least_weight * result.baseline.cost.motion.extruded;
    if (value_of(goal, print.cost) < value_of(goal, result.chosen.cost) &&
        print.cost.motion.extruded >= least)
        result.chosen = std::move(print);
}

std::vector<double> rotations_to_try(std::span<const LayerParts> parts, const Jury& jury,
                                     const OptimizeOptions& options, Effort& effort) {
    if (options.rotation) return {*options.rotation};
    std::vector<double> rotations = promising_rotations(parts, jury, options, tried_whole, effort);
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
    const auto turned = [&](double rotation) {
        return Print{on_bed(parts, rotation, machine.printer), {}, lines, plan, program};
    };
    const double told = options.baseline_rotation;
    if (!fits_bed(turned(told).parts, machine.printer))
        throw Error("the part does not fit the bed of " + machine.printer.name +
                        "; turn it (--rotate) or choose another printer",
                    Fault::infeasible);
    Optimum result;
    result.baseline = judged(uniform(turned(told), plan.angle), told, machine);
    result.simple = judged(uniform(turned(told), 0), told, machine);
    result.chosen = result.baseline;
    consider(result.simple, result, options.goal);

    Effort effort;
    const std::vector<double> rotations = rotations_to_try(parts, jury, options, effort);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        tell(options.progress,
             0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(rotations.size()),
             "choosing layer by layer");
        Print print = turned(rotations[i]);
        print.choices = best_choices(print.parts, jury, options, effort);
        consider(judged(std::move(print), rotations[i], machine), result, options.goal);
    }
    result.candidates = effort.candidates;
    result.evaluated = effort.evaluated;
    tell(options.progress, 1, "done");
    return result;
}

}  // namespace bead
