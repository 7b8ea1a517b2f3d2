// The machine that a G-code file is judged on, from the command line, the environment and what the
// slicer noted in the file; each limit knows where it came from.
#pragma once
#include "gcode/slicer_notes.h"
#include "job/sourced_printer.h"
#include "options.h"

namespace bead::cli {

struct MachineChoice {
    Machine machine;
    SourcedLimits limits;     // those of the machine's printer
    FirmwareChoice firmware;  // that of the machine's motion
    std::vector<std::string> warnings, notes;
};

MachineChoice machine_choice(const MachineOptions& options, const SlicerNotes& notes);

}  // namespace bead::cli
