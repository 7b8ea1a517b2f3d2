#include "geom/simplify.h"

#include <utility>

namespace bead {
namespace {

double square_distance(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 along = b - a;
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    const Vec2 off = p - (a + t * along);
    return dot(off, off);
}

}  // namespace

Polyline simplified(const Polyline& line, double tolerance) {
    if (line.size() < 3) return line;
    std::vector<bool> kept(line.size(), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> spans{{0, line.size() - 1}};
    while (!spans.empty()) {
        const auto [first, last] = spans.back();
        spans.pop_back();
        double farthest = tolerance * tolerance;
        std::size_t split = first;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double off = square_distance(line[first], line[last], line[i]);
            if (off > farthest) {
                farthest = off;
                split = i;
            }
        }
        if (split == first) continue;
        kept[split] = true;
        spans.emplace_back(first, split);
        spans.emplace_back(split, last);
    }
    Polyline result;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (kept[i]) result.push_back(line[i]);
    return result;
}

Polyline simplified_loop(const Polyline& loop, double tolerance) {
    if (loop.size() < 4) return loop;
    Polyline closed = loop;
    closed.push_back(loop.front());
    closed = simplified(closed, tolerance);
    closed.pop_back();
    return closed;
}

Region simplified(const Region& region, double tolerance) {
    Region result;
    for (const Polygon& polygon : region) {
        Polygon smaller{simplified_loop(polygon.outer, tolerance), {}};
        if (smaller.outer.size() < 3) continue;
        for (const Polyline& hole : polygon.holes) {
            Polyline loop = simplified_loop(hole, tolerance);
            if (loop.size() >= 3) smaller.holes.push_back(std::move(loop));
        }
        result.push_back(std::move(smaller));
    }
    return result;
}

}  // namespace bead
