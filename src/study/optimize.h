// The print that costs least: how the part is turned, and for each layer the pattern of its infill
// and the angle of its lines. Slices, walls and what is skin or infill do not depend on these and
// are computed once; layers that are alike are judged once.
//
// Each candidate layer is planned, made into commands, simulated as the firmware would and charged.
// The sequence of layers then follows by dynamic programming, so that lines of neighbouring layers
// still cross. Energy is that of the physics model: a motor that stands still under current is
// charged like one that moves, so no angle wins by standing nearly still (docs/optimize.md).
//
// Whole prints are judged at the end: the baseline, the same print with lines along X and Y (what
// anybody can have without a search), and what was found. The cheapest is the choice.
#pragma once
#include "core/progress.h"
#include "study/judge.h"
#include "study/print.h"

namespace bead {

enum class Goal { machine_energy, xy_energy, time };

struct OptimizeOptions {
    Goal goal = Goal::machine_energy;
    std::vector<NamedPattern> patterns{bead::patterns.begin(),
                                       bead::patterns.begin() + usual_patterns};
    double angle_step = pi / 12;     // rad, between the angles that are tried
    double rotation_step = pi / 12;  // rad, between the part's rotations that are tried first
    std::optional<double> rotation;  // rad; the part stays as it is told
    double least_crossing = pi / 3;  // rad, at which lines of neighbouring layers cross at least
    double baseline_rotation = 0;    // rad
    int threads = 0;
    Progress progress;
};

struct JudgedPrint {
    Print print;
    double rotation = 0;  // rad
    Assessment cost;
};

struct Optimum {
    JudgedPrint baseline;  // as told
    JudgedPrint simple;    // as told, but lines along X and Y
    JudgedPrint chosen;
    long candidates = 0;  // combinations of rotation, pattern and angle considered per layer
    long evaluated = 0;   // layers planned and simulated for it
};

// `parts` as sliced, not yet on the bed; `plan` and `program` as for the baseline. Throws
// Error{infeasible} when the part does not fit the bed.
Optimum optimize(std::span<const LayerParts> parts, const PlanOptions& plan,
                 const ProgramOptions& program, const Machine& machine,
                 const OptimizeOptions& options);

// What the goal makes of an assessment: J (machine_energy, xy_energy) or s (time).
double value_of(Goal goal, const Assessment& assessment);

}  // namespace bead
