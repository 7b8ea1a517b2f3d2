#include "smooth/chord_error.h"

#include "core/expects.h"
#include "smooth/segment_lattice.h"

namespace bead {

double chord_error(const Toolpath& layer, Role role, std::span<const Polyline> curves) {
    BEAD_EXPECTS(!curves.empty());
    constexpr double step = 0.1;  // mm
    const SegmentLattice near(curves);
    double farthest = 0;
    for (const Path& path : layer) {
        if (path.role != role) continue;
        Polyline line;
        for (const Vec3& p : path.points) line.push_back(flat(p));
        farthest = near.farthest(places_along(line, step), farthest);
    }
    return farthest;
}

std::vector<Polyline> boundary_curves(const Region& region) {
    std::vector<Polyline> curves;
    const auto add = [&](Polyline loop) {
        loop.push_back(loop.front());
        curves.push_back(std::move(loop));
    };
    for (const Polygon& polygon : region) {
        add(polygon.outer);
        for (const Polyline& hole : polygon.holes) add(hole);
    }
    return curves;
}

}  // namespace bead
