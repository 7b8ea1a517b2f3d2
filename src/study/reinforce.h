// A part's infill laid for its load: densities, lines along the stresses, braces and patches where
// a test says, from several starts side by side; the best by the score of `strength`, the patterns
// of slicers among the candidates. docs/stress-lines.md.
//
//     const Reinforced part = reinforced(load_case, {.seeds = 6});
//     layer_of(part.best().layout, load_case.print);
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "strength/strength.h"
#include "study/densities.h"
#include "study/strengthen.h"

namespace bead {

struct ReinforceOptions {
    int seeds = 1;  // starts of the stripe patterns
    std::uint32_t first_seed = 0;
    bool slicer_patterns = true;  // candidates too
    double shortest_brace = 2.5;  // mm
    double pixel = 0;             // mm, of the tests on the way; 0: a quarter of the bead's width
    int threads = 0;
    Progress progress;
};

struct Candidate {
    std::string name;
    Layout layout;
    Strength strength;
    std::vector<StrengthenStep> steps;
    bool is_baseline = false;  // a slicer's pattern
};

struct Reinforced {
    std::vector<Candidate> candidates;  // the best first
    double stiffness_bound = 0;         // N/mm, of the homogenised layout
    [[nodiscard]] const Candidate& best() const { return candidates.front(); }
};

// Nothing if walls and pads leave too little to lay lines of.
std::optional<Reinforced> reinforced(const LoadCase& load_case, const ReinforceOptions& options);

// The deposited area (mm²) that the case asks for, and the least that its walls, pads and a thin
// web of lines take.
double asked_area(const LoadCase& load_case);
double least_area(const LoadCase& load_case);

// N per g: what a design bears over what it weighs.
double strength_to_weight(const Strength& strength);

}  // namespace bead
