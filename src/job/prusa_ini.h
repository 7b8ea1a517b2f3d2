// The part of a PrusaSlicer configuration (File > Export > Export Config) that has a counterpart
// here.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "job/settings.h"

namespace bead {

// Takes what is known; percentages of other settings are resolved when all lines are read. Returns
// the names of the rest, in the order of the file, with the reason where a known name's value
// cannot be used. Throws Error at a line that is no `name = value`, and for a value out of range.
std::vector<std::string> read_prusa_ini(Settings& settings, std::string_view text,
                                        const std::string& file);

}  // namespace bead
