// Wavefront OBJ: of all that the format knows, points (v) and faces (f). Faces of more than three
// corners are cut into a fan of triangles. Points that are equal to the bit become one.
#pragma once
#include <string_view>

#include "mesh/parsed.h"

namespace bead {

ParsedMesh parse_obj(std::string_view bytes, std::string_view name);

}  // namespace bead
