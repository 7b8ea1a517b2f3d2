// Where a line crosses others: signs of areas on either side, sides sorted by x so that only those
// nearby are asked. Lines that only touch may count or not.
//
//     const Crossings others(first_family);
//     for (const double along : others.on(line)) …      // mm from the line's start
#pragma once
#include <span>
#include <vector>

#include "geom/polygon.h"

namespace bead {

class Crossings {
  public:
    explicit Crossings(std::span<const Polyline> lines);
    // In rising order.
    [[nodiscard]] std::vector<double> on(const Polyline& line) const;

  private:
    struct Side {
        Vec2 from, to;
        double low = 0;  // of x
    };
    std::vector<Side> sides_;  // by `low`
    double widest_ = 0;        // mm, along x, of any side
};

}  // namespace bead
