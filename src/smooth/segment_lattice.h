// Many lines, and how far a point is from the nearest of them: their segments sorted into square
// cells, so that a point looks at the cells around it only.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/polygon.h"

namespace bead {

class SegmentLattice {
  public:
    explicit SegmentLattice(std::span<const Polyline> lines, double cell = 1);

    // mm; infinity if there are no lines.
    [[nodiscard]] double distance_to(Vec2 point) const;

  private:
    struct Segment {
        Vec2 a, b;
    };
    [[nodiscard]] std::int64_t column(double x) const;
    [[nodiscard]] std::int64_t row(double y) const;
    [[nodiscard]] double nearest_in_ring(Vec2 point, std::int64_t ring) const;
    [[nodiscard]] double nearest_in_cell(Vec2 point, std::int64_t column, std::int64_t row) const;
    template <class Visit>
    void for_each_cell(const Segment& segment, const Visit& visit) const;

    double cell_;
    Box2 box_;
    std::int64_t columns_ = 0, rows_ = 0;
    std::vector<Segment> segments_;
    std::vector<std::uint32_t> begin_, entries_;  // of every cell the segments' numbers
};

// The corners and the places between them, at most `step` mm apart.
Polyline places_along(const Polyline& line, double step);

}  // namespace bead
