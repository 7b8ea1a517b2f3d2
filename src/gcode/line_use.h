// What a line of G-code is for, as far as it matters to whoever moves other lines past it.
#pragma once
#include <string_view>

#include "gcode/layer_reader.h"

namespace bead {

// `text` with its line end; the states on either side of it.
LineUse use_of(std::string_view text, const FileState& before, const FileState& after);

}  // namespace bead
