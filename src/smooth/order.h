// In which order, from which seams and in which directions strokes are printed so that the travel
// between them is short. First by the distances between the strokes (nearest first, then 2-opt and
// Or-opt), then the cheapest row of seams for that order (Viterbi 1967), then strokes moved to
// better places while there are any, within a fixed number of comparisons.
#pragma once
#include <limits>

#include "smooth/chain.h"

namespace bead {

struct OrderOptions {
    double radius = 2;  // mm, of travel
    // mm; from that length on filament is pulled back for it, which counts as so much travel.
    double retracted_from = std::numeric_limits<double>::infinity(), retraction = 0;
    bool reorder = true;             // otherwise only seams and directions are chosen
    std::size_t most = 600;          // strokes of one phase; more stay in the order given
    std::size_t effort = 1'000'000;  // comparisons of two ends, about
};

struct OrderedStroke {
    std::size_t chain = 0, winding = 0;
};

// All strokes of one phase come before those of the next; `phases` rises with the chains.
std::vector<OrderedStroke> ordered(const std::vector<Chain>& chains, const std::vector<int>& phases,
                                   Vec2 start, const OrderOptions& options);

}  // namespace bead
