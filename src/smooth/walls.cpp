#include "smooth/walls.h"

#include <algorithm>

namespace bead {
namespace {

std::vector<Polyline> lines_of_walls(const Toolpath& layer) {
    std::vector<Polyline> walls;
    for (const Path& path : layer) {
        if (path.role != Role::outer_wall && path.role != Role::wall) continue;
        walls.emplace_back();
        walls.back().reserve(path.points.size());
        for (const Vec3& point : path.points) walls.back().push_back(flat(point));
    }
    return walls;
}

SegmentGrid grid_of(const std::vector<Polyline>& lines) {
    std::vector<SegmentGrid::Line> open;
    open.reserve(lines.size());
    for (const Polyline& line : lines) open.push_back({line, false});
    return SegmentGrid(open, 1);
}

}  // namespace

Walls::Walls(const Toolpath& layer) : grid_(grid_of(lines_of_walls(layer))) {}

bool Walls::are_crossed_by(const Polyline& line, double at_ends) const {
    const double all = length(line);
    double at = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec2 a = line[i - 1], b = line[i];
        const double part = distance(a, b);
        const double from = std::max(0.0, at_ends - at), to = std::min(part, all - at_ends - at);
        at += part;
        if (from < to && grid_.is_crossed(lerp(a, b, from / part), lerp(a, b, to / part)))
            return true;
    }
    return false;
}

}  // namespace bead
