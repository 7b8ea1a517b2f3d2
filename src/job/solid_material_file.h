// The strength of materials, by name or from a file: the keys young_mpa, poisson, tensile_mpa and
// compressive_mpa of a material's TOML (data/materials, each with its source); of those that are
// sintered also green_scale_plane and green_scale_height, what is printed over what it becomes.
#pragma once
#include <string>

#include "fem/load_case.h"
#include "job/toml_reader.h"

namespace bead {

// What solids there are lie in, from foams to diamond and tungsten.
inline constexpr Range solid_mpa{.low = 1e-3, .high = 1e7};
inline constexpr Range solid_density{.low = 1e-3, .high = 30};  // g/cm³

// Throws Error for an unknown name, and for a material of which the strength is not known.
SolidMaterial load_solid_material(const std::string& name_or_file);

// The temperatures to print it at (material_file.h).
PrintHeat load_print_heat(const std::string& name_or_file);

}  // namespace bead
