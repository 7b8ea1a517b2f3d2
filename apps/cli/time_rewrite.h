// What has to change in a G-code file so that it tells its true times, found by simulating it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "gcode/edits.h"
#include "gcode/reader.h"
#include "machine_choice.h"

namespace bead::cli {

struct TimeRewrite {
    MachineChoice choice;
    GcodeReport file{};
    std::optional<double> slicer_estimate{};  // s
    double simulated = 0;                     // s
    double told = 0;                          // s, as the file will tell
    std::vector<Edit> edits{};
    std::vector<std::string> warnings{};  // lines for people; the edits tell them too
};

TimeRewrite time_rewrite(const std::string& file, const MachineOptions& options);

}  // namespace bead::cli
