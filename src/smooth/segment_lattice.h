// Many lines, and how far a point is from the nearest of them: their segments sorted into square
// cells, so that a point looks at the cells around it only.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/polygon.h"
#include "smooth/cell_table.h"

namespace bead {

class SegmentLattice {
  public:
    explicit SegmentLattice(std::span<const Polyline> lines, double cell = 1);

    // mm; infinity if there are no lines.
    [[nodiscard]] double distance_to(Vec2 point) const;
    // The largest of the places' distances, or `least` if none is larger. For places in a row that
    // is found much sooner than each distance: a place with any segment within what is known
    // already needs no more looking.
    [[nodiscard]] double farthest(const Polyline& places, double least = 0) const;

  private:
    struct Segment {
        Vec2 a, b;
    };
    [[nodiscard]] std::int64_t column(double x) const;
    [[nodiscard]] std::int64_t row(double y) const;
    struct Nearest {
        double distance;
        std::size_t segment;
    };
    void look_in_cell(Vec2 point, std::int64_t column, std::int64_t row, Nearest& nearest) const;
    void look_in_ring(Vec2 point, std::int64_t ring, Nearest& nearest) const;
    [[nodiscard]] Nearest nearest_to(Vec2 point) const;
    [[nodiscard]] Nearest followed(Vec2 point, std::size_t segment) const;
    [[nodiscard]] double distance_of(std::size_t segment, Vec2 point) const;
    template <class Visit>
    void for_each_cell(const Segment& segment, const Visit& visit) const;

    double cell_;
    Box2 box_;
    std::int64_t columns_ = 0, rows_ = 0;
    std::vector<Segment> segments_;
    CellTable numbers_;  // of the segments that touch every cell
};

// The corners and the places between them, at most `step` mm apart.
Polyline places_along(const Polyline& line, double step);

}  // namespace bead
