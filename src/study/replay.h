// All prints of the experiment, made, timed and charged by this program, beside what was published.
// Both sides are energies of the X and Y motors by Eq. 28.
#pragma once
#include <functional>

#include "core/progress.h"
#include "study/experiment.h"

namespace bead {

struct PublishedRun {
    ExperimentRun run;
    double energy = 0;     // J
    bool suspect = false;  // by our audit: equal to another run's, or far from its neighbours
};

// Rows that cannot be right whatever the set-up are not: 30 of the rectangle that equal other rows,
// and 12 of the drop's spiral, the same at all angles of the fill.
bool usable(const ExperimentRun& run);

struct RunCost {
    double energy = 0;    // J, X and Y motors by Eq. 28
    double standing = 0;  // J, in the standing form
    double duration = 0;  // s
    Features features;
};
RunCost run_cost(const Print& print);

struct ReplayedRun {
    PublishedRun published;
    RunCost ours;
};
std::vector<ReplayedRun> replayed(std::span<const PublishedRun> runs, int threads = 0,
                                  const Progress& progress = {});

struct Agreement {
    int rows = 0;
    double mape = 0;   // mean of |ours / published - 1|
    double worst = 0;  // the largest of them
    double spearman = 0;
    std::array<double, shape_names.size()> by_shape{};  // Spearman's of each shape
};
using RunFilter = std::function<bool(const PublishedRun&)>;
Agreement agreement(std::span<const ReplayedRun> runs, const RunFilter& wanted);

// Rank correlation; equal values share the mean of their ranks. 0 where one side is all equal.
double spearman(std::span<const double> a, std::span<const double> b);

}  // namespace bead
