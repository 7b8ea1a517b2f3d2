// The slow obvious answer to "inside?": how often the loops wind round the point, by summed angles.
#pragma once
#include <cmath>

#include "geom/polygon.h"

namespace bead::test {

inline double turns_round(const Polyline& loop, Vec2 point) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = loop[i] - point, b = loop[(i + 1) % loop.size()] - point;
        sum += std::atan2(cross(a, b), dot(a, b));
    }
    return sum / (2 * pi);
}

inline bool wound(const Region& region, Vec2 point) {
    double sum = 0;
    for (const Polygon& polygon : region) {
        sum += turns_round(polygon.outer, point);
        for (const Polyline& hole : polygon.holes) sum += turns_round(hole, point);
    }
    return std::lround(sum) != 0;
}

}  // namespace bead::test
