#include "smooth/metrics.h"
#include "smooth/walls.h"

namespace bead {

int travels_crossing_walls(const Toolpath& layer) {
    constexpr double at_ends = 0.05;  // mm
    const Walls walls(layer);
    int count = 0;
    Polyline travel;
    const auto finish = [&] {
        if (walls.are_crossed_by(travel, at_ends)) ++count;
        travel.clear();
    };
    for (const Path& path : layer) {
        if (path.role != Role::travel) {
            finish();
            continue;
        }
        for (const Vec3& point : path.points) travel.push_back(flat(point));
    }
    finish();
    return count;
}

}  // namespace bead
