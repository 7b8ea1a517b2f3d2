// Which of many loops may come near to a place: a raster that holds for every cell the loops that
// pass within reach of it, and some a little farther off.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geom/polygon.h"
#include "smooth/cell_table.h"

namespace bead {

class Neighbourhood {
  public:
    // Of loops that do not repeat their first point; reach in mm, above 0.
    Neighbourhood(const std::vector<const Polyline*>& loops, double reach);

    // All loops within reach of the point, in order, and perhaps others.
    [[nodiscard]] std::span<const std::uint32_t> around(Vec2 point) const;

  private:
    void add(std::uint32_t loop, const Polyline& points, std::vector<std::uint32_t>& last);
    void add(std::uint32_t loop, Vec2 point, std::vector<std::uint32_t>& last);

    double cell_;  // mm
    Vec2 low_;
    std::int64_t columns_ = 1, rows_ = 1;
    std::vector<CellEntry> entries_;
    CellTable loops_;
};

}  // namespace bead
