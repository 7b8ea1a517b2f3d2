// A printer from Klipper's configuration file, printer.cfg: what its motion is planned with, bed
// and nozzle. What Klipper would take by default or derive from other values is stated too, as the
// machine goes by it; the rest of the printer is the usual one's. Files that it includes are not
// followed, which a warning says.
#pragma once
#include "job/data_file.h"
#include "job/printer_file.h"

namespace bead {

// Throws Error, with file and line, for what Klipper would not start with: no [printer], no
// max_velocity or max_accel, a value that is no number or out of its range.
PrinterFile read_klipper_config(const DataFile& config, const Printer& usual);

}  // namespace bead
