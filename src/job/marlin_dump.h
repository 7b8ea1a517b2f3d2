// A printer's limits from the text that Marlin answers to M503: its lines M92, M201, M203, M204 and
// M205, with or without "echo:" or ";" before them. The rest of the printer is the usual one's.
#pragma once
#include "job/data_file.h"
#include "job/printer_file.h"

namespace bead {

// A value that is no number or no limit is passed over, and a warning says so, with file and line.
// Throws Error where no line states a limit, or where the dump is in inches.
PrinterFile read_marlin_dump(const DataFile& dump, const Printer& usual);

}  // namespace bead
