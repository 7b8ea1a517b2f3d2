// The nearest of many lines, found through buckets of their segments: for questions of the kind
// "does a bead pass within half a millimetre of here?", asked a hundred thousand times.
//
//     const LineIndex index(lines, 1.0);
//     if (const auto near = index.nearest(p, 0.35)) …      // near->line, near->along,
//     near->distance
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "geom/polygon.h"

namespace bead {

class LineIndex {
  public:
    // `bucket`: mm, about the distance that is asked for.
    LineIndex(std::span<const Polyline> lines, double bucket);

    struct Near {
        std::size_t line = 0;
        double along = 0;  // mm from the line's start
        double distance = 0;
        Vec2 at;
    };
    // The nearest point of any line within `reach` (mm).
    [[nodiscard]] std::optional<Near> nearest(Vec2 p, double reach) const;

  private:
    struct Segment {
        Vec2 from, to;
        std::size_t line = 0;
        double along = 0;
    };
    [[nodiscard]] std::size_t bucket_at(int column, int row) const;

    double bucket_;
    Box2 box_;
    int columns_ = 0, rows_ = 0;
    std::vector<Segment> segments_;
    std::vector<std::size_t> starts_;   // of each bucket in `entries_`
    std::vector<std::size_t> entries_;  // segments
};

}  // namespace bead
