// A case's supports and loads put on the nodes of a pixel grid. A load's traction is integrated
// over its stretch of the boundary; each piece of it goes to the nearest solid pixel's nodes by
// that pixel's shape functions, so that on a boundary along the grid it is the consistent load and
// anywhere the resultant is exact. A support holds the nodes whose share of the stretch is at least
// a quarter of a pixel's side; one without length holds the nearest node.
#pragma once
#include <optional>

#include "fem/load_case.h"
#include "fem/pixel_model.h"

namespace bead {

struct PatchOptions {
    double reach = 0;  // mm, from the boundary to the nearest solid pixel; 0: three pixels
};

// Where a load or support finds no solid within reach on more than half of its length the answer is
// nothing.
std::optional<Held> held_nodes(const PixelModel& model, const Region& part,
                               const std::vector<Support>& supports,
                               const PatchOptions& options = {});
std::optional<PixelVector> load_vector(const PixelModel& model, const Region& part,
                                       const std::vector<Load>& loads,
                                       const PatchOptions& options = {});

}  // namespace bead
