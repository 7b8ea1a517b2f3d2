// What a solver answers: displacements and how it went.
#pragma once
#include <vector>

namespace bead {

struct Displacement {
    std::vector<double> values;  // mm, per unknown
    bool converged = false;
    double residual = 0;  // |f - K u| / |f| over free unknowns
    int iterations = 0;
};

}  // namespace bead
