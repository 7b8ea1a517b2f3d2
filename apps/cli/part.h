// From the command line to a part ready to be planned, and from a plan to a file.
#pragma once
#include <functional>

#include "options.h"
#include "study/print.h"

namespace bead::cli {

// Loads and slices, telling what had to be mended, and splits layers into walls, skin and infill.
// Throws Error{infeasible} when the part is larger than the printer however it is turned.
std::vector<LayerParts> parts_from(const ProcessOptions& options, const Settings& settings,
                                   const Printer& printer, const Console& console);

ProgramOptions program_options(const Settings& settings, const Machine& machine);

// Writes the print's G-code with the slicer's usual notes at its end; what is written is judged on
// the way.
Assessment write_print(const std::string& file, const Print& print, const Machine& machine,
                       bool relative_e, const std::string& what, const LayerSink& layers = {});

double grams(double filament_mm, const Machine& machine);

}  // namespace bead::cli
