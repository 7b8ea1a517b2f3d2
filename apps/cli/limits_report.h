// A machine's limits with where each came from and how the file changed it, for people and for
// programs.
#pragma once
#include "gcode_file.h"
#include "json_result.h"

namespace bead::cli {

// name: {value, source, changed?: {times, first_line, first, last}}; of each firmware's limits
// those that it has, beside the ones that all printer files have.
Json limits_json(const JudgedFile& judged);
void print_limits(const Console& console, const JudgedFile& judged);

}  // namespace bead::cli
