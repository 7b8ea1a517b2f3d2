// Gives equal points one index. Equal means to the bit, with -0 and 0 the same.
//
//     Welder welder(corners);
//     for (Vec3 corner : …) triangle[k] = welder.index(corner);
//     mesh.points = welder.points();
#pragma once
#include <vector>

#include "geom/vec.h"

namespace bead {

class Welder {
  public:
    // `expected`: about how many different points will come.
    explicit Welder(std::size_t expected);
    int index(Vec3 point);
    std::vector<Vec3> points() && { return std::move(points_); }

  private:
    [[nodiscard]] std::size_t slot_of(const Vec3& point) const;
    void grow();

    std::vector<Vec3> points_;
    std::vector<int> slots_;  // open addressing, at most half full; -1: free; size a power of two
};

}  // namespace bead
