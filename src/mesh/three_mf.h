// 3MF (3D Manufacturing Format, core specification 1.3, with the paths of the production
// extension): a zip archive with an XML model. All objects that the build section places are read,
// through components and transforms; items with printable="0" and objects of type "other" are not.
#pragma once
#include <string_view>

#include "mesh/parsed.h"

namespace bead {

ParsedMesh parse_three_mf(std::string_view bytes, std::string_view name);

}  // namespace bead
