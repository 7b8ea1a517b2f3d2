// What `strength` and `reinforce` say of designs.
#pragma once
#include <CLI/CLI.hpp>

#include "console.h"
#include "job/case_file.h"
#include "json_result.h"
#include "strength/strength.h"
#include "study/bed_place.h"

namespace bead::cli {

struct NamedStrength {
    std::string name;
    Strength strength;
    bool is_baseline = false;
    std::optional<BedPlace> place{};  // of a file
};

// One line per design, the strongest per weight first.
void print_strengths(const Console& console, std::vector<NamedStrength> designs);
// Of designs that would buckle out of their plane before they bear what is said, unless guided.
void warn_of_sideways(const Console& console, const std::vector<NamedStrength>& designs);
Json strength_json(const NamedStrength& design);

// The case with what options say instead of the file.
struct CaseOptions {
    std::string file;
    std::string solid;          // a material's name, instead of the case's [material]
    double fill = 0;            // 0: as the case says
    double pixel = 0;           // mm, of the test; 0: a sixth of a bead
    std::vector<double> range;  // degrees and mm by which all loads may turn and move
};
void declare(CLI::App& command, CaseOptions& options);
LoadCase case_of(const CaseOptions& options);

}  // namespace bead::cli
