// What is wrong with a mesh, in numbers. None of it keeps a mesh from being sliced; all of it is
// worth a warning.
#pragma once
#include "mesh/mesh.h"

namespace bead {

struct MeshReport {
    long open_edges = 0;          // with one triangle
    long non_manifold_edges = 0;  // with more than two
    long flipped_edges = 0;       // whose two triangles disagree on which side is outside
    long degenerate = 0;          // triangles without area
    [[nodiscard]] bool is_watertight() const {
        return open_edges == 0 && non_manifold_edges == 0 && flipped_edges == 0;
    }
};

MeshReport check(const Mesh& mesh);

}  // namespace bead
