// What `beadwork simulate` found in a file, for people, for programs and as a table.
#pragma once
#include <ostream>

#include "limits_report.h"

namespace bead::cli {

void print_simulation(const Console& console, const JudgedFile& judged,
                      const MachineOptions& options);
Json simulation_json(const JudgedFile& judged, const MachineOptions& options);

// One row per layer and role, dwells as a role of their own; layer 0 is what comes before the
// first. Times of all rows add up to the printing time. The file's name is a column if asked for.
void write_layers_head(std::ostream& out, bool with_name);
void write_layers(std::ostream& out, const JudgedFile& judged, bool with_name);

}  // namespace bead::cli
