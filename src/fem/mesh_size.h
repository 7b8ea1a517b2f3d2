// How large elements are to be at each place: a size asked for, smaller where the boundary bends or
// the part is narrow, growing back gradually away from there.
#pragma once
#include <vector>

#include "geom/along.h"

namespace bead {

struct MeshSizes {
    double size = 1;          // mm, side of an element where nothing asks for less
    double turn = 0.13;       // rad, that one side of a bent boundary may turn by
    double growth = 0.3;      // mm per mm
    double least = 1.0 / 30;  // of `size`
    int across = 2;           // elements across a narrow place
};

inline constexpr double corner_turn = 0.35;  // rad; a boundary that turns more has a corner there

class SizeField {
  public:
    SizeField(const std::vector<MeasuredLoop>& loops, const MeshSizes& wanted);
    [[nodiscard]] double at(Vec2 p) const;
    [[nodiscard]] double least() const;

  private:
    struct Source {
        Vec2 place;
        double size = 0;
    };
    void add(Vec2 place, double size);

    MeshSizes wanted_;
    std::vector<Source> sources_;
};

// By how much the loop turns at its point i, rad, positive to the left.
double turn_at(const MeasuredLoop& loop, std::size_t i);

}  // namespace bead
