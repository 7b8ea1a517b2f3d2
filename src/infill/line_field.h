// What a family of lines shall follow: at each place a direction and the distance to the next line.
// Pure geometry: where the directions come from (stress, flow, a designer's wish) is not known
// here.
#pragma once
#include <functional>

#include "geom/vec.h"

namespace bead {

using DirectionField = std::function<Vec2(Vec2)>;  // unit vectors along the lines; the sign is free

struct LineField {
    DirectionField direction;
    std::function<double(Vec2)> spacing;  // mm, > 0
};

}  // namespace bead
