// The first situation's principal stresses drawn over the part: red where tension is the larger,
// blue where compression is; short lines along both directions, as long as the stress is large.
#pragma once
#include <string>

#include "fem/sheet.h"

namespace bead::cli {

std::string stress_picture(const LoadCase& load_case, const Sheet& sheet);

}  // namespace bead::cli
