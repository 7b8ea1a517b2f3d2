// What a slicer's own settings (machine_max_acceleration_x = 9000,1000; gcode_flavor = klipper) say
// of the machine: PrusaSlicer's names, and those that differ in Bambu Studio and OrcaSlicer. The
// same settings come at the end of a G-code file and, for a script that the slicer runs, in the
// environment (SLIC3R_MACHINE_MAX_ACCELERATION_X). Of several values, one per print mode, the
// first, normal mode's, counts.
#pragma once
#include <map>
#include <string>

#include "job/statement.h"

namespace bead {

using SlicerSettings = std::map<std::string, std::string, std::less<>>;

enum class SlicerPlace { file, environment };

// No limits if machine_limits_usage says that they are to be ignored. A value that is no number or
// not above zero is passed over with a warning, but for zeros that mean "not limited". `where`
// names the place in what is said.
Statement slicer_statement(const SlicerSettings& settings, SlicerPlace place,
                           const std::string& where);

// The environment's SLIC3R_ variables under their settings' names.
SlicerSettings slicer_environment(const char* const* environment);

}  // namespace bead
