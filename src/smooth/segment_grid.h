// Segments of many lines found by place: which lines come near to a point, and how near.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geom/polygon.h"
#include "smooth/cell_table.h"

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
    SegmentGrid(const std::vector<Line>& lines, double reach, double cell = 0);

    // Every line within reach, once, by number.
    [[nodiscard]] std::vector<NearLine> near(Vec2 point) const;
    // How far the nearest line is but for one, if one is within reach.
    [[nodiscard]] std::optional<double> nearest_other(Vec2 point, std::size_t line) const;
    // Whether all lines but two keep at least this distance, which is within reach.
    [[nodiscard]] bool is_clear(Vec2 point, double distance, std::array<std::size_t, 2> but) const;
    // Whether any line crosses the segment.
    [[nodiscard]] bool is_crossed(Vec2 a, Vec2 b) const;

  private:
    struct Segment {
        Vec2 a, b;
        std::uint32_t line;
    };
    struct Cells {  // both ends included
        std::int64_t left, right, bottom, top;
    };
    [[nodiscard]] Cells cells_around(Vec2 point, double distance) const;
    void add(std::uint32_t line, Vec2 a, Vec2 b, std::vector<CellEntry>& entries);
    // Until the visitor, given a segment, returns false. In any order; one may come again.
    template <class Visit>
    bool visit(const Cells& cells, const Visit& visitor) const;

    double reach_, cell_;  // mm
    Vec2 low_;
    std::int64_t columns_ = 1, rows_ = 1;
    std::vector<Segment> segments_;
    CellTable numbers_;  // of the segments in every cell that they may touch
};

}  // namespace bead
