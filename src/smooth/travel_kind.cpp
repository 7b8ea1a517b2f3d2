#include "smooth/travel_kind.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace bead {
namespace {

constexpr double from_wall = 0.3;  // mm at either end, where the wall is that was printed
constexpr double usual = 2;        // mm

}  // namespace

TravelPace usual_pace(const Toolpath& layer) {
    std::map<std::pair<double, double>, double> ways;  // mm, by speed and acceleration
    for (const Path& path : layer)
        if (path.role == Role::travel) ways[{path.speed, path.acceleration}] += length(path);
    TravelPace usual;
    double longest = 0;
    for (const auto& [pace, way] : ways)
        if (way > longest) {
            longest = way;
            usual = {pace.first, pace.second};
        }
    return usual;
}

TravelKind::TravelKind(const Toolpath& layer) : pace_(usual_pace(layer)), walls_(layer) {
    double shortest = std::numeric_limits<double>::infinity(), longest_without = 0;
    for (const Path& path : layer) {
        if (path.role != Role::travel || path.points.size() < 2) continue;
        if (path.retracted)
            shortest = std::min(shortest, length(path));
        else
            longest_without = std::max(longest_without, length(path));
    }
    const bool any = shortest < std::numeric_limits<double>::infinity();
    by_walls_ = !any || longest_without > shortest;
    shortest_ = any ? shortest : std::max(usual, longest_without);
}

bool TravelKind::is_retracted(const Polyline& points) const {
    return length(points) >= shortest_ && (!by_walls_ || walls_.are_crossed_by(points, from_wall));
}

Path TravelKind::path_along(const Polyline& points, double z) const {
    Path path;
    path.speed = pace_.speed;
    path.acceleration = pace_.acceleration;
    path.retracted = is_retracted(points);
    path.points.reserve(points.size());
    for (const Vec2 point : points) path.points.push_back(at_height(point, z));
    return path;
}

}  // namespace bead
