// What a slicer wrote about the machine and the print in its file's comments, read from the file's
// ends without reading the moves. PrusaSlicer and its kin keep their settings at the end, a line
// each ("; machine_max_jerk_x = 10,10"); Bambu Studio keeps them in a block at the top. How long
// the print takes stands at the end (PrusaSlicer), at the top (Bambu Studio; Cura, ";TIME:1234") or
// layer by layer (Cura, ";TIME_ELAPSED:1234.5").
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace bead {

struct SlicerNotes {
    std::map<std::string, std::string, std::less<>> settings;  // by the slicer's own names
    std::optional<double> estimate;                            // s, of the normal print mode
};

SlicerNotes slicer_notes(const std::filesystem::path& file);

}  // namespace bead
