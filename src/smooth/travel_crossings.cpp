#include <algorithm>

#include "smooth/metrics.h"

namespace bead {
namespace {

struct Wall {
    Polyline line;
    Box2 box;
};

Polyline flattened(const Path& path) {
    Polyline line;
    for (const Vec3& p : path.points) line.push_back(flat(p));
    return line;
}

std::vector<Wall> walls_of(const Toolpath& layer) {
    std::vector<Wall> walls;
    for (const Path& path : layer) {
        if (path.role != Role::outer_wall && path.role != Role::wall) continue;
        Polyline line = flattened(path);
        const Box2 box = bounds(line);
        walls.push_back({std::move(line), box});
    }
    return walls;
}

bool overlap(const Box2& a, const Box2& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const auto side = [](Vec2 from, Vec2 to, Vec2 p) { return cross(to - from, p - from); };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// Shorter by `cut` at its beginning; empty if that is all of it.
Polyline cut_at_start(const Polyline& line, double cut) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double piece = distance(line[i - 1], line[i]);
        if (piece > cut) {
            Polyline rest{lerp(line[i - 1], line[i], cut / piece)};
            rest.insert(rest.end(), line.begin() + static_cast<std::ptrdiff_t>(i), line.end());
            return rest;
        }
        cut -= piece;
    }
    return {};
}

Polyline cut_at_both_ends(Polyline line, double cut) {
    line = cut_at_start(line, cut);
    std::ranges::reverse(line);
    return cut_at_start(line, cut);
}

bool crosses(const Polyline& travel, const Wall& wall) {
    for (std::size_t i = 1; i < travel.size(); ++i) {
        Box2 box;
        box.include(travel[i - 1]);
        box.include(travel[i]);
        if (!overlap(box, wall.box)) continue;
        for (std::size_t k = 1; k < wall.line.size(); ++k)
            if (cross_each_other(travel[i - 1], travel[i], wall.line[k - 1], wall.line[k]))
                return true;
    }
    return false;
}

}  // namespace

int travels_crossing_walls(const Toolpath& layer) {
    constexpr double at_ends = 0.05;  // mm
    const std::vector<Wall> walls = walls_of(layer);
    int count = 0;
    Polyline travel;
    const auto finish = [&] {
        const Polyline middle = cut_at_both_ends(travel, at_ends);
        if (std::ranges::any_of(walls, [&](const Wall& wall) { return crosses(middle, wall); }))
            ++count;
        travel.clear();
    };
    for (const Path& path : layer) {
        if (path.role != Role::travel) {
            finish();
            continue;
        }
        const Polyline line = flattened(path);
        travel.insert(travel.end(), line.begin(), line.end());
    }
    finish();
    return count;
}

}  // namespace bead
