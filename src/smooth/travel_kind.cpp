#include "smooth/travel_kind.h"

#include <algorithm>
#include <limits>

namespace bead {
namespace {

constexpr double from_wall = 0.3;  // mm at either end, where the wall is that was printed
constexpr double usual = 2;        // mm

std::vector<Polyline> walls_of(const Toolpath& layer) {
    std::vector<Polyline> walls;
    for (const Path& path : layer) {
        if (path.role != Role::outer_wall && path.role != Role::wall) continue;
        walls.emplace_back();
        walls.back().reserve(path.points.size());
        for (const Vec3& point : path.points) walls.back().push_back(flat(point));
    }
    return walls;
}

std::vector<SegmentGrid::Line> as_lines(const std::vector<Polyline>& lines) {
    std::vector<SegmentGrid::Line> result;
    result.reserve(lines.size());
    for (const Polyline& line : lines) result.push_back({line, false});
    return result;
}

}  // namespace

TravelKind::TravelKind(const Toolpath& layer) : walls_(as_lines(walls_of(layer)), 1) {
    double shortest = std::numeric_limits<double>::infinity(), longest_without = 0;
    bool found = false;
    for (const Path& path : layer) {
        if (path.role != Role::travel || path.points.size() < 2) continue;
        if (!found) {
            speed_ = path.speed;
            acceleration_ = path.acceleration;
        }
        found = true;
        if (path.retracted)
            shortest = std::min(shortest, length(path));
        else
            longest_without = std::max(longest_without, length(path));
    }
    const bool any = shortest < std::numeric_limits<double>::infinity();
    by_walls_ = !any || longest_without > shortest;
    shortest_ = any ? shortest : std::max(usual, longest_without);
}

bool TravelKind::crosses_walls(const Polyline& points) const {
    const double all = length(points);
    double at = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2 a = points[i - 1], b = points[i];
        const double part = distance(a, b);
        const double from = std::max(0.0, from_wall - at),
                     to = std::min(part, all - from_wall - at);
        at += part;
        if (from < to && walls_.is_crossed(lerp(a, b, from / part), lerp(a, b, to / part)))
            return true;
    }
    return false;
}

bool TravelKind::is_retracted(const Polyline& points) const {
    return length(points) >= shortest_ && (!by_walls_ || crosses_walls(points));
}

Path TravelKind::path_along(const Polyline& points, double z) const {
    Path path;
    path.speed = speed_;
    path.acceleration = acceleration_;
    path.retracted = is_retracted(points);
    path.points.reserve(points.size());
    for (const Vec2 point : points) path.points.push_back(at_height(point, z));
    return path;
}

}  // namespace bead
