#include "smooth/lane.h"

#include <algorithm>

#include "geom/deviation.h"
#include "smooth/same_place.h"

namespace bead {
namespace {

bool meets(const Path& path, const Path& next) {
    return path.role == next.role && length(path.points.back() - next.points.front()) <= same_place;
}

void append(Lane& lane, const Path& path) {
    const Flow flow{section(path.bead), path.speed, path.role, 0, path.bead.height};
    for (const Vec3& point : path.points) {
        lane.level = lane.level && std::abs(point.z - lane.z) <= 1e-9;
        const Vec2 here = flat(point);
        if (!lane.points.empty() && distance(lane.points.back(), here) <= same_place) continue;
        if (!lane.points.empty()) lane.flows.push_back(flow);
        lane.points.push_back(here);
    }
    lane.volume += volume(path);
    ++lane.paths;
}

Lane begun(const Path& path, std::size_t index) {
    Lane lane;
    lane.role = path.role;
    lane.height = path.bead.height;
    lane.z = path.points.front().z;
    lane.acceleration = path.acceleration;
    lane.first_path = index;
    return lane;
}

void close(Lane& lane) {
    const double gap = distance(lane.points.front(), lane.points.back());
    const double width = width_of(lane.flows.back().section, lane.height);
    if (!lane.level || lane.points.size() < 4 || gap > width) return;
    if (length(lane.points) < 4 * width) return;
    lane.closed = true;
    if (gap <= same_place)
        lane.points.pop_back();
    else
        lane.flows.push_back(lane.flows.back());
}

}  // namespace

bool alike(const Flow& a, const Flow& b) {
    if (a.speed != b.speed || a.role != b.role || a.ramp != b.ramp || a.height != b.height)
        return false;
    return a.ramp > 0 || std::abs(a.section - b.section) <= 0.02 * std::max(a.section, b.section);
}

std::vector<Lane> lanes_of(const Toolpath& layer) {
    std::vector<Lane> lanes;
    const Path* before = nullptr;
    for (std::size_t i = 0; i < layer.size(); ++i) {
        const Path& path = layer[i];
        if (path.points.empty()) continue;
        const bool deposits = path.role != Role::travel && volume(path) > 0;
        if (deposits) {
            if (before == nullptr || !meets(*before, path)) lanes.push_back(begun(path, i));
            append(lanes.back(), path);
        }
        before = deposits ? &path : nullptr;
    }
    std::erase_if(lanes, [](const Lane& lane) { return lane.points.size() < 2; });
    for (Lane& lane : lanes) close(lane);
    return lanes;
}

Lane cleaned(Lane lane, double shortest, double straight) {
    const Polyline& from = lane.points;
    const std::size_t n = from.size();
    Polyline points{from.front()};
    std::vector<Flow> flows;
    std::size_t kept = 0;  // index of the last point that stays
    for (std::size_t i = 1; i < n; ++i) {
        const bool last = i + 1 == n && !lane.closed;
        const Vec2 next = from[(i + 1) % n];
        bool needless = !last && alike(lane.flows[i - 1], lane.flows[std::min(i, n - 1)]);
        if (needless && distance(points.back(), from[i]) >= shortest)
            for (std::size_t k = kept + 1; needless && k <= i; ++k)
                needless = segment_distance(points.back(), next, from[k]) <= straight;
        if (needless) continue;
        flows.push_back(lane.flows[i - 1]);
        points.push_back(from[i]);
        kept = i;
    }
    if (lane.closed) flows.push_back(lane.flows.back());
    if (points.size() < (lane.closed ? 3 : 2)) return lane;
    lane.points = std::move(points);
    lane.flows = std::move(flows);
    return lane;
}

double width_of(const Lane& lane) { return width_of(lane.flows.front().section, lane.height); }

double width_of(double section, double height) {
    const double half_discs = pi / 4 * height * height;
    if (section < half_discs) return section / (pi / 4 * height);
    return (section - half_discs) / height + height;
}

}  // namespace bead
