#include "geom/arc.h"

#include <algorithm>
#include <limits>

namespace bead {

double circumradius(Vec2 a, Vec2 b, Vec2 c) {
    const double sides = distance(a, b) * distance(b, c) * distance(c, a);
    const double turn = std::abs(cross(b - a, c - a));
    // Below this the points are on a line as far as their coordinates can say.
    if (turn <= 1e-12 * std::max(dot(b - a, b - a), dot(c - b, c - b)))
        return std::numeric_limits<double>::infinity();
    return sides / (2 * turn);
}

double sagitta(double radius, double chord) {
    if (std::isinf(radius)) return 0;
    const double half = std::min(chord / 2, radius);
    // r - √(r² - h²) without the difference of near numbers.
    return half * half / (radius + std::sqrt(radius * radius - half * half));
}

double mean_chord_sagitta(const Polyline& line) {
    if (line.size() < 3) return 0;
    double sum = 0;
    for (std::size_t i = 0; i + 2 < line.size(); ++i)
        sum += sagitta(circumradius(line[i], line[i + 1], line[i + 2]),
                       distance(line[i], line[i + 1]));
    return sum / static_cast<double>(line.size() - 2);
}

}  // namespace bead
