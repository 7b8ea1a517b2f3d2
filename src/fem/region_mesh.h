// A part's mesh of six-node triangles: points along the boundary, a triangular lattice inside,
// Delaunay's triangles of both, moved to the middle of their neighbours a few times. Where a side
// of the boundary is no side of a triangle it is halved until it is (Delaunay refinement of
// segments, Ruppert 1995). Middles of sides lie on the boundary's curve; round holes are truly
// round.
#pragma once
#include <optional>

#include "fem/load_case.h"
#include "fem/mesh_size.h"
#include "fem/plane_mesh.h"
#include "fem/stretch.h"

namespace bead {

// Nodes are put at both ends of every one of the `stretches`. Nothing if the boundary cannot be
// met, which is so for corners sharper than some ten degrees.
std::optional<PlaneMesh> region_mesh(const Region& part, const std::vector<Circle>& circles,
                                     const std::vector<BoundarySpan>& stretches,
                                     const MeshSizes& sizes);

}  // namespace bead
