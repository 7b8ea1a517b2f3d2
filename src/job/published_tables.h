// The tables of Somade (2023) that come with the program (data/somade2023), as the structs that
// they are compared with.
#pragma once
#include <string>
#include <vector>

#include "study/replay.h"

namespace bead {

std::vector<PublishedRun> published_runs();  // Appendix C, the thesis's order

// What the thesis prints of one print: its features and its energy.
struct FeatureRow {
    std::string part;   // "rectangle" and "bracket" of the appendices, F, L and K of Table 3
    ExperimentRun run;  // its shape means nothing but for the rectangle
    Features features;  // without the axis time
    double energy = 0;  // J; 0 where it is not printed
};
// Appendices D and E, rows that have all four features. The energy of one is not printed there but
// in Appendix C, and is taken from it.
std::vector<FeatureRow> appendix_rows();
std::vector<FeatureRow> calibration_rows();  // Table 3, energies measured

}  // namespace bead
