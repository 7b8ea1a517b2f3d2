// Printers by name or from somebody's own file: a PRINTER.toml (docs/energy.md lists the keys of
// [power]), Klipper's configuration (klipper_config.h) or Marlin's answer to M503 (marlin_dump.h).
//
//     const Printer printer = load_printer("prusa-mk3s");   // or "my-printer.toml", "printer.cfg"
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "job/statement.h"
#include "machine/printer.h"

namespace bead {

inline constexpr const char* usual_printer = "prusa-mk3s";

struct PrinterFile {
    Printer printer;  // complete: what the file leaves open is as of the usual printer
    Statement says;
};

// What ends in .toml, .cfg (Klipper), .txt or .log (Marlin) is a file, anything else a built-in
// name. A key that a PRINTER.toml leaves out has the value of prusa-mk3s; of [vibration], if the
// file has that table, the value of the example machine (machine/vibration.h). Throws Error: usage
// for an unknown name, input for a file that says something wrong.
PrinterFile read_printer_file(const std::string& name_or_file);
Printer load_printer(const std::string& name_or_file);

// The printer with one setting changed, "limits.acceleration_mm_s2=2000": any key of a
// PRINTER.toml. Throws Error{usage}, naming `--set`.
PrinterFile with_setting(const Printer& printer, std::string_view setting);

// The built-in ones, in the alphabet's order.
std::vector<std::string> printer_names();

}  // namespace bead
