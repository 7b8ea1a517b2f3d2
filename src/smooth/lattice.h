// A square lattice of places inside a region, and which of them are near a line: how far a bead
// reaches, answered for all places at once.
#pragma once
#include <cstdint>
#include <vector>

#include "geom/polygon.h"

namespace bead {

struct NearPlace {
    std::uint32_t place;
    float distance;  // mm, to the nearest point of the line
};

class Lattice {
  public:
    Lattice(const Region& region, double pitch);

    [[nodiscard]] std::size_t size() const { return size_; }
    // All places within `reach` of the open line, each once, in order.
    [[nodiscard]] std::vector<NearPlace> near(const Polyline& line, double reach) const;
    // Lowers the distance of every place from which the line is nearer, up to `reach`.
    void bring_near(std::vector<float>& nearest, const Polyline& line, double reach) const;

  private:
    template <class Visit>
    void for_each_near(Vec2 a, Vec2 b, double reach, const Visit& visit) const;
    [[nodiscard]] std::uint32_t& number(std::int64_t column, std::int64_t row) {
        return numbers_[static_cast<std::size_t>(row * columns_ + column)];
    }

    double pitch_;
    Vec2 low_;
    std::int64_t columns_ = 0, rows_ = 0;
    std::vector<std::uint32_t> numbers_;  // of places, from 1; 0: outside
    std::size_t size_ = 0;
};

}  // namespace bead
