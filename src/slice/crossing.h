// Which triangles each of a stack of horizontal planes crosses. A point that lies on a plane counts
// as above it, so a triangle is crossed by the planes above its lowest point, up to its highest
// point.
#pragma once
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace bead {

// The planes [first, end) of a triangle.
struct PlaneRange {
    int first = 0, end = 0;
};

// One per triangle; empty for triangles that have a point twice. `planes` ascend (mm).
std::vector<PlaneRange> crossed_planes(const Mesh& mesh, std::span<const double> planes);

// The triangles of each plane in [first, end), ascending, in one array.
class CrossedTriangles {
  public:
    CrossedTriangles(std::span<const PlaneRange> ranges, int first, int end);
    [[nodiscard]] std::span<const int> of(int plane) const;

  private:
    int first_;
    std::vector<std::size_t> begin_;
    std::vector<int> triangles_;
};

}  // namespace bead
