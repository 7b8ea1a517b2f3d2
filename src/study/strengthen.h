// The rest of the bead, spent where a test says: braces while the structure would buckle before it
// breaks, patches that lower the highest stress while it would break before it buckles, tested
// again after each handful.
#pragma once
#include <vector>

#include "study/layout.h"

namespace bead {

struct StrengthenOptions {
    double area = 0;     // mm², all beads
    double pixel = 0.2;  // mm, of the tests on the way
    int modes = 8;
    double margin = 1.05;  // buckling shall come this much later than breaking
    double brace_step = 0.01, patch_step = 0.006;  // of the area, per test
    double full = 0.0035;                          // of the area: what is not worth another step
    double shortest_brace = 2.5;                   // mm
};

struct StrengthenStep {
    bool braces = false;  // else patches; the first step is neither
    std::size_t lines = 0;
    double area = 0;             // mm², after it
    double failure_factor = 0;   // of the loads
    double buckling_factor = 0;  // as last known: patches alone do not call for a new search
};

struct Strengthened {
    Layout layout;
    std::vector<StrengthenStep> steps;
};

Strengthened strengthened(const LoadCase& load_case, Layout layout,
                          const StrengthenOptions& options);

}  // namespace bead
