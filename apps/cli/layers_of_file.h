// The layers that a G-code file lays for a case's part, moved to where the case draws it.
#pragma once
#include <string>

#include "fem/load_case.h"
#include "toolpath/path.h"

namespace bead::cli {

// Without skirt and support. Parts stand somewhere on a bed: their box is put on the case's. Throws
// Error if the box is not the part's, or nothing is laid.
std::vector<Toolpath> layers_of_file(const std::string& file, const LoadCase& load_case,
                                     double filament);

}  // namespace bead::cli
