#include "gcode/arc_centre.h"

#include <algorithm>
#include <cmath>

namespace bead {

std::optional<Vec2> arc_centre(Vec2 chord, double radius, bool clockwise) {
    const Vec2 half = chord / 2;
    const double size = length(half);
    if (radius == 0 || size == 0) return {};
    const double square = (radius - size) * (radius + size);
    const double height = std::sqrt(std::max(0.0, square));
    const double side = clockwise != (radius < 0) ? -1 : 1;  // 1: it lies left of the chord
    return half + side * height / size * left_of(half);
}

}  // namespace bead
