// Judges a G-code file on a machine, with the limits that apply to it: those of --printer if one
// was named, else those that the slicer noted in the file, else the default printer's; and on top
// whatever the file itself sets while it runs.
#pragma once
#include "gcode/reader.h"
#include "options.h"

namespace bead::cli {

struct JudgedFile {
    Machine machine;  // as the print began
    std::string limits_source;
    Assessment cost{};
    GcodeReport file{};
    std::optional<double> slicer_estimate{};  // s
};

JudgedFile judge_file(const std::string& file, const MachineOptions& options,
                      const Console& console, const MotionSink& watch = {});

// "4.2 M lines of PrusaSlicer; 12 × M73 not understood"
std::string described(const GcodeReport& file);

}  // namespace bead::cli
