// Options of `reinforce --mode thesis` and its design: lines as Uncu (2023) lays them.
#pragma once
#include "options.h"
#include "study/reinforce.h"
#include "study/thesis_lines.h"

namespace bead::cli {

struct ThesisModeOptions {
    std::string seeds = "edges";
    ThesisOptions lines;
    double crossing_flow = 1;
};
void declare(CLI::App& command, ThesisModeOptions& options);

// One candidate, tested. `file` is what messages call the case. Throws Error where the case asks
// for what this mode cannot do.
Reinforced thesis_design(const LoadCase& load_case, const ThesisModeOptions& options,
                         const std::string& file);

}  // namespace bead::cli
