// Mesh to layers. Each layer is the cut of the mesh by the plane half-way up the layer; the pieces
// of that cut are chained through the mesh's own edges, so that a closed mesh gives closed
// outlines. Outlines that stay open are closed where their ends nearly meet, and counted.
//
//     const Slices slices = slice(mesh, {.layer_height = 0.2});
//     for (const Layer& layer : slices.layers) area(layer.region);
#pragma once
#include <vector>

#include "core/progress.h"
#include "geom/polygon.h"
#include "mesh/mesh.h"

namespace bead {

struct SliceOptions {
    double layer_height = 0.2;        // mm
    double first_layer_height = 0.2;  // mm
    double closing_gap = 2.0;         // mm, ends of an open outline this near are joined
    double resolution = 0.0125;       // mm, detail below this is dropped from the outlines
    int threads = 0;                  // 0: all
    Progress progress = {};
};

struct Layer {
    double z = 0;       // mm, top of the layer, from the mesh's lowest point
    double height = 0;  // mm
    Region region;      // x and y as in the mesh
};

struct Slices {
    std::vector<Layer>
        layers;  // from the bottom; a layer inside a gap of the part has an empty region
    long closed_outlines = 0;   // open outlines whose ends were joined
    long dropped_outlines = 0;  // open outlines given up
    double dropped_length = 0;  // mm
};

// The last layer is the one whose middle is still below the top of the mesh. A flat face exactly
// half-way up a layer counts as below the cut.
Slices slice(const Mesh& mesh, const SliceOptions& options);

}  // namespace bead
