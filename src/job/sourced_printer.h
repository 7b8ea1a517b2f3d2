// The machine that a print starts on, put together from everything that says something of it; for
// each limit the strongest source that states it counts, and stays named. From the strongest:
// `--set`, `--printer`, the environment that a slicer gives to its scripts, the slicer's notes in
// the file, the usual printer. (What the file sets while it runs comes on top: limit_trail.h.)
//
//     const SourcedPrinter sourced = sourced_printer({.printer = "ender3", .notes =
//     notes.settings}); sourced.limits.source(named_limit("jerk_mm_s"));   // "built-in printer
//     ender3"
#pragma once
#include <string>
#include <vector>

#include "job/limit_table.h"
#include "job/slicer_machine.h"
#include "machine/printer.h"

namespace bead {

struct PrinterSources {
    std::vector<std::string> set{};  // "limits.acceleration_mm_s2=2000"; the last of a name counts
    std::string printer{};  // a name or a file, as read_printer_file takes it; empty: none named
    SlicerSettings environment{};
    SlicerSettings notes{};
};

struct SourcedPrinter {
    Printer printer;
    SourcedLimits limits;                      // those of the printer
    FirmwareChoice firmware;                   // as far as sources say; else Prusa's
    std::vector<std::string> warnings, notes;  // lines for people, see Statement
};

SourcedPrinter sourced_printer(const PrinterSources& sources);

}  // namespace bead
