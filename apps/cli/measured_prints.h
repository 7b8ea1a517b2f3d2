// Measured prints from whatever they were recorded in: a table of features or of G-code files, a
// print server's history, a power meter's log beside the file that was printed.
#pragma once
#include <string>
#include <vector>

#include "energy/observation.h"
#include "json_result.h"
#include "options.h"

namespace bead::cli {

struct MeasuredOptions {
    std::string file;  // table or history
    std::string power_log, gcode;
    std::string gcode_folder;  // of the history's files
    std::string sensor;        // of the history
    std::string scope;         // "motors", "machine" or "": by the kind of file
    MachineOptions machine;
};

struct MeasuredPrints {
    std::vector<Observation> prints;
    bool of_machine = false;    // else of the X and Y motors
    bool parts_of_one = false;  // stretches of one print
    std::string kind;           // what the file was taken for
    std::vector<std::string> inputs;
    std::vector<std::string> notes;  // lines for people
    Json details;                    // of the log or the history; null for tables
};

MeasuredPrints measured_prints(const MeasuredOptions& options, const Console& console);

// Those of a log: energies of stretches after heating up, with what was drawn, when, and how well
// it is known.
MeasuredPrints logged_print(const MeasuredOptions& options, const Console& console);

}  // namespace bead::cli
