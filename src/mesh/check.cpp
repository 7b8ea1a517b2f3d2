#include "mesh/check.h"

#include <algorithm>

#include "mesh/edges.h"
#include "mesh/facet.h"

namespace bead {
MeshReport check(const Mesh& mesh) {
    MeshReport report;
    report.degenerate = std::ranges::count_if(
        mesh.triangles, [&](const auto& triangle) { return !has_area(mesh, triangle); });
    for_each_edge(sorted_sides(mesh), [&](std::span<const Side> sides) {
        if (sides.size() == 1) ++report.open_edges;
        if (sides.size() > 2) ++report.non_manifold_edges;
        if (sides.size() == 2 && sides[0].rising == sides[1].rising) ++report.flipped_edges;
    });
    return report;
}

}  // namespace bead
