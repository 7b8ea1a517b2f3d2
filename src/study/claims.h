// The strategies that the thesis advises, counted in the energies of runs, whoever's they are. A
// cell is a group of runs that differ in one thing only; a cell with a run missing is not counted.
#pragma once
#include <optional>

#include "study/replay.h"

namespace bead {

struct Tally {
    int holds = 0, of = 0;
    bool operator==(const Tally&) const = default;
};

class RunEnergies {
  public:
    void add(const ExperimentRun& run, double energy);
    [[nodiscard]] std::optional<double> of(const ExperimentRun& run) const;

  private:
    std::array<std::optional<double>, 300> by_run_;
};

struct Tallies {
    Tally diagonal_worst;      // of 0°, 45° and 90° of the infill, 45° costs most
    Tally ninety_best;         // 90° costs least
    Tally rectilinear_lowest;  // of the five patterns
    Tally part_0_lowest;       // of the four part angles
    // Of the shapes whose 60 runs are all there: the means of the three infill angles (the five
    // patterns) are wider apart, in squares, than those of the four part angles.
    Tally infill_outweighs_part, pattern_outweighs_part;
};
Tallies tallies(const RunEnergies& energies);

// The same print with X and Y exchanged: infill and part both turned from 0° to 90°. Mean of
// (turned / straight - 1) over patterns and shapes but the drop and the triangle, which are not
// their own mirror image.
double exchange_effect(const RunEnergies& energies);

// Of the pairs of runs of which one coasts farther and speeds up less, those in which it costs
// less.
struct ChargedFeatures {
    Features features;
    double energy = 0;  // J
};
Tally coasting_pays(std::span<const ChargedFeatures> runs);
Tally operator+(const Tally& a, const Tally& b);

}  // namespace bead
