// Judges G-code files on a machine, with the limits that apply to each (machine_choice.h) and, on
// top, whatever the file itself sets while it runs.
#pragma once
#include "gcode/reader.h"
#include "job/limit_trail.h"
#include "machine_choice.h"
#include "study/asked_speeds.h"

namespace bead::cli {

struct JudgedFile {
    std::string name;
    MachineChoice choice;  // as the print begins
    LimitTrail trail{};    // how the file changes its limits
    Limits last{};         // limits at the end
    AskedSpeeds asked{};
    Assessment cost{};
    GcodeReport file{};
    std::optional<double> slicer_estimate{};  // s
    std::vector<std::string> warnings{};      // lines for people
};

// Says its warnings. `watch` is told all motion, `listener` all energy over time.
JudgedFile judge_file(const std::string& file, const MachineOptions& options,
                      const Console& console, Judging judging, const MotionSink& watch = {},
                      const PowerListener& listener = {});

// Each on a thread of its own; warnings, and the error if there is one, come in the files' order.
std::vector<JudgedFile> judge_files(const std::vector<std::string>& files,
                                    const MachineOptions& options, int threads,
                                    const Console& console, Judging judging);

// "93482 lines by PrusaSlicer"
std::string described(const GcodeReport& file);
// "12 × M73, 3 × M900": what has no effect here; "" if there is nothing.
std::string ignored_in(const GcodeReport& file);

}  // namespace bead::cli
