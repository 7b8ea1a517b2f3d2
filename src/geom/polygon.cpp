#include "geom/polygon.h"

#include <algorithm>
#include <limits>

#include "geom/deviation.h"

namespace bead {
namespace {

template <class Visit>
void for_each_loop(const Region& region, const Visit& visit) {
    for (const Polygon& polygon : region) {
        visit(polygon.outer);
        for (const Polyline& hole : polygon.holes) visit(hole);
    }
}

}  // namespace

double length(std::span<const Vec2> line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
    return sum;
}

double loop_length(std::span<const Vec2> loop) {
    return loop.empty() ? 0 : length(loop) + distance(loop.back(), loop.front());
}

double perimeter(const Region& region) {
    double sum = 0;
    for_each_loop(region, [&](const Polyline& loop) { sum += loop_length(loop); });
    return sum;
}

double signed_area(std::span<const Vec2> loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        sum += cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
    return sum / 2;
}

double area(const Polygon& polygon) {
    double sum = signed_area(polygon.outer);
    for (const Polyline& hole : polygon.holes) sum += signed_area(hole);
    return sum;
}

double area(const Region& region) {
    double sum = 0;
    for (const Polygon& polygon : region) sum += area(polygon);
    return sum;
}

Box2 bounds(std::span<const Vec2> points) {
    Box2 box;
    for (const Vec2 p : points) box.include(p);
    return box;
}

Box2 bounds(const Region& region) {
    Box2 box;
    for (const Polygon& polygon : region) box.include(bounds(polygon.outer));
    return box;
}

bool contains(const Region& region, Vec2 point) {
    bool inside = false;
    for_each_loop(region, [&](const Polyline& loop) {
        for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
            const Vec2 a = loop[j], b = loop[i];
            if ((a.y > point.y) == (b.y > point.y)) continue;
            if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
        }
    });
    return inside;
}

double boundary_distance(const Region& region, Vec2 point) {
    double nearest = std::numeric_limits<double>::infinity();
    for_each_loop(region, [&](const Polyline& loop) {
        for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++)
            nearest = std::min(nearest, segment_distance(loop[j], loop[i], point));
    });
    return nearest;
}

Polyline moved(Polyline line, double angle, Vec2 about, Vec2 shift) {
    const Vec2 turn = unit(angle);
    for (Vec2& p : line) p = rotated(p - about, turn) + about + shift;
    return line;
}

Region moved(Region region, double angle, Vec2 about, Vec2 shift) {
    for (Polygon& polygon : region) {
        polygon.outer = moved(std::move(polygon.outer), angle, about, shift);
        for (Polyline& hole : polygon.holes) hole = moved(std::move(hole), angle, about, shift);
    }
    return region;
}

}  // namespace bead
