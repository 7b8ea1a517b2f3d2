// What `stress` says of a case of the plane: a table for people, JSON for scripts, fields for
// ParaView.
#pragma once
#include <optional>
#include <ostream>

#include "console.h"
#include "fem/sheet.h"
#include "fem/sideways.h"
#include "json_result.h"

namespace bead::cli {

struct StressReport {
    const LoadCase& load_case;
    const Sheet& sheet;
    std::optional<double> change_by_mesh;   // of the first situation's work, part of it
    std::vector<SolidBuckling> buckling{};  // per situation
};

void print_stress(const Console& console, const StressReport& report);
Json stress_json(const StressReport& report);
void write_vtu(std::ostream& out, const StressReport& report);

}  // namespace bead::cli
