// The G-code that Bambu Studio and OrcaSlicer put into a .gcode.3mf, a zip archive: one file for
// each plate of the project, of which the first is taken.
#pragma once
#include <filesystem>

#include "gcode/text_source.h"

namespace bead {

bool is_archive(const std::filesystem::path& file);

// Unpacks as it is read. Throws Error if the archive is damaged or holds no sliced plate.
OpenedText open_plate(const std::filesystem::path& file);

}  // namespace bead
