// Printers by name or from somebody's own PRINTER.toml (docs/energy.md lists the keys of [power]).
//
//     const Printer printer = load_printer("prusa-mk3s");   // or "my-printer.toml"
#pragma once
#include <string>
#include <vector>

#include "machine/printer.h"

namespace bead {

// A key that a file leaves out has the value of prusa-mk3s; [vibration] is accepted and not read.
// Throws Error: usage for an unknown name, input for a file that says something wrong.
Printer load_printer(const std::string& name_or_file);

// The built-in ones, in the alphabet's order.
std::vector<std::string> printer_names();

}  // namespace bead
