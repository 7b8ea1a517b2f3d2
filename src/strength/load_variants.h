// The situations that a case stands for: each as it is, and, where loads may turn or move, with
// them at the ends of their ranges, both ways and together.
#pragma once
#include <vector>

#include "fem/load_case.h"

namespace bead {

struct Variant {
    std::size_t situation = 0;  // of the case; its supports hold
    double turn = 0, move = 0;  // fractions of the ranges, -1 … 1
    std::vector<Load> loads;    // without ranges
};

std::vector<Variant> load_variants(const LoadCase& load_case);

// N, the sum of what the loads pull with.
double total_force(const std::vector<Load>& loads);

}  // namespace bead
