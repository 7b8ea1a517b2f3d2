// read_gcode with the size of its chunks to choose: for tests that show it does not matter.
#pragma once
#include "gcode/line_reader.h"
#include "gcode/reader.h"

namespace bead {

GcodeReport read_source(const TextSource& source, const ReadOptions& options,
                        const LineLimits& limits, const CommandSink& sink);

}  // namespace bead
