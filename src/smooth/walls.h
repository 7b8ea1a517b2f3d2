// The walls of a layer, and what crosses them: travel over a wall leaves a mark or oozes where it
// is seen.
#pragma once
#include "smooth/segment_grid.h"
#include "toolpath/path.h"

namespace bead {

class Walls {
  public:
    explicit Walls(const Toolpath& layer);

    // Whether the line does, but for so much (mm) at both its ends.
    [[nodiscard]] bool are_crossed_by(const Polyline& line, double at_ends) const;

  private:
    SegmentGrid grid_;
};

}  // namespace bead
