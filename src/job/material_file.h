// Materials by name or from somebody's own MATERIAL.toml (data/materials/pla.toml shows every key).
//
//     const Material material = load_material("pla");   // or "my-material.toml"
#pragma once
#include <string>
#include <vector>

#include "machine/material.h"

namespace bead {

// A key that a file leaves out has the value of pla, but hotend_first_c that of hotend_c.
// Throws Error: usage for an unknown name, input for a file that says something wrong.
Material load_material(const std::string& name_or_file);

// The built-in ones, in the alphabet's order.
std::vector<std::string> material_names();

}  // namespace bead
