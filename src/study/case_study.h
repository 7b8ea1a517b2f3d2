// The case study of Somade (2023): one bracket, printed with five patterns, at three angles of the
// infill and at three of the part. The thesis's bracket is somebody else's model; this is a
// stand-in of the same kind (a plate with eyes, holes and a slot, longest along X), so orders and
// ratios can be compared, energies cannot. The set-up is that of the experiment.
#pragma once
#include "study/experiment.h"

namespace bead {

// About 90 × 50 mm, two bores, a slot, concave flanks.
Region bracket_outline();

// J of X and Y motors by Eq. 28; the shape of the runs is not looked at.
std::vector<double> bracket_energies(std::span<const ExperimentRun> runs, int threads = 0);

// What the thesis concludes from the bracket, counted over the patterns. A pattern with a run
// missing is not counted.
struct BracketRun {
    ExperimentRun run;
    double energy = 0;  // J
};
struct BracketFindings {
    int patterns = 0;
    int diagonal_worse = 0;      // infill at 45° costs more than at 0° and at 90°
    int ninety_better = 0;       // at 90° less than at 0°
    int part_0_lowest = 0;       // of the part angles
    int rectilinear_lowest = 0;  // of the five patterns, counted over `set_ups`
    int set_ups = 0;             // pairs of angles
    double below_worst = 0;      // of part angle 0: the cheapest run, as a part of the dearest
    double below_usual = 0;      // and of rectilinear at 45°
    ExperimentRun best, worst;
};
BracketFindings bracket_findings(std::span<const BracketRun> runs);

}  // namespace bead
