// What a slicer wrote about the machine and the print in its file's comments, read without reading
// the moves: PrusaSlicer and its kin keep their settings ("; machine_max_jerk_x = 10,10") and their
// estimate at the end, Cura its estimate (";TIME:1234") at the top or (";TIME_ELAPSED:1234.5")
// layer by layer.
#pragma once
#include <filesystem>
#include <optional>

#include "toolpath/command.h"

namespace bead {

// Of the normal print mode. Nothing if the file says none or says that they are to be ignored.
std::optional<SetLimits> slicer_limits(const std::filesystem::path& file);

// Printing time in s that the slicer expects, normal mode.
std::optional<double> slicer_estimate(const std::filesystem::path& file);

}  // namespace bead
