// Which part of a layer's material is solid: what the layers above or below leave uncovered.
#pragma once
#include <span>
#include <vector>

#include "geom/polygon.h"

namespace bead {

// Intersection and difference, without the specks that rounding leaves.
Region common_part(const Region& a, const Region& b);
Region without(const Region& from, const Region& cut);
// Without what is narrower than that.
Region without_slivers(const Region& region, double narrowest);

// Of every region, what it has in common with the `count - 1` that follow it (count > 0); empty
// where fewer follow. Takes about log2(count) intersections per region.
std::vector<Region> running_intersections(std::vector<Region> regions, int count, int threads);

struct Split {
    Region sparse, skin, top;  // top: solid and not under the layer above
};

// `covered` is the part of the material that need not be solid, `above` the next layer's outline.
// Solid parts narrower than `narrowest` (mm) count as sparse, sparse parts narrower than twice that
// as solid.
Split split(const Region& material, const Region& covered, const Region& above, double narrowest);

}  // namespace bead
