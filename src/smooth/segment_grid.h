// Segments of many lines found by place: which lines come near to a point, and how near.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/polygon.h"

namespace bead {

struct NearLine {
    std::size_t line = 0;
    double distance = 0;  // mm
};

class SegmentGrid {
  public:
    // `reach`: the farthest that will be looked (mm). Closed lines do not repeat their first point.
    struct Line {
        std::span<const Vec2> points;
        bool closed = false;
    };
    SegmentGrid(const std::vector<Line>& lines, double reach);

    // Every line within reach, once, by number.
    [[nodiscard]] std::vector<NearLine> near(Vec2 point) const;

  private:
    struct Segment {
        std::uint64_t cell;
        std::uint32_t line;
        Vec2 a, b;
    };
    [[nodiscard]] std::uint64_t cell(std::int64_t column, std::int64_t row) const;
    void add(std::uint32_t line, Vec2 a, Vec2 b);

    double reach_;
    Vec2 low_;
    std::int64_t columns_ = 1, rows_ = 1;
    std::vector<Segment> segments_;    // by cell; in every cell that their boxes touch
    std::vector<std::size_t> starts_;  // of the cells in `segments_`, and the end
};

}  // namespace bead
