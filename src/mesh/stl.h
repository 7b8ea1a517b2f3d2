// STL: triangles as loose corners, binary (little-endian floats) or ASCII. Equal corners become one
// point; normals are ignored, the order of the corners says which side is outside.
#pragma once
#include <string_view>

#include "mesh/parsed.h"

namespace bead {

ParsedMesh parse_stl(std::string_view bytes, std::string_view name);

}  // namespace bead
