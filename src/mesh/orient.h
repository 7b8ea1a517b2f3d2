// Makes neighbouring triangles agree on which side is outside. Each connected piece of the surface
// keeps the direction that the larger part of its area has; a piece that is wholly inside out, or a
// cavity, stays as it is.
#pragma once
#include <optional>

#include "mesh/edges.h"

namespace bead {

// Nothing when all neighbours agree already. `sides` are the mesh's own sorted sides.
std::optional<Mesh> reoriented(const Mesh& mesh, std::span<const Side> sides);

}  // namespace bead
