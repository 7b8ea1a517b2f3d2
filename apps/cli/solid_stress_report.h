// What `stress` says of a case in space.
#pragma once
#include <ostream>

#include "console.h"
#include "fem/solid.h"
#include "json_result.h"

namespace bead::cli {

void print_solid(const Console& console, const SolidCase& solid, const SolidAnswer& answer);
Json solid_json(const SolidAnswer& answer);
void write_vtu(std::ostream& out, const SolidAnswer& answer);

}  // namespace bead::cli
