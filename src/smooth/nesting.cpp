#include "smooth/nesting.h"

#include <algorithm>
#include <map>
#include <optional>

#include "smooth/segment_grid.h"

namespace bead {
namespace {

constexpr double beads_apart = 1.8;  // of the mean width, at corners too
constexpr int samples = 48;

bool is_wall(const Lane& lane) {
    return lane.closed && lane.level && (lane.role == Role::outer_wall || lane.role == Role::wall);
}

// Some slicers lay what overhangs of a wall higher; between beads of two heights nothing is linked.
bool may_follow(const Lane& lane, const Lane& next) {
    const auto is_as_high = [&](const Flow& flow) { return flow.height == lane.height; };
    return next.role != Role::outer_wall && std::ranges::all_of(lane.flows, is_as_high) &&
           std::ranges::all_of(next.flows, is_as_high);
}

Polyline even_samples(const Lane& lane) {
    Polyline points;
    const double all = loop_length(lane.points);
    double at = 0, next = 0;
    for (std::size_t i = 0; i < lane.points.size(); ++i) {
        const Vec2 a = lane.points[i], b = lane.points[(i + 1) % lane.points.size()];
        const double part = distance(a, b);
        for (; next < at + part && points.size() < samples; next += all / samples)
            points.push_back(lerp(a, b, (next - at) / part));
        at += part;
    }
    return points;
}

struct Beside {
    int count = 0;   // samples that have it within reach
    double sum = 0;  // of the distances
};

// For each wall, the walls beside it.
using Besides = std::vector<std::map<std::size_t, Beside>>;

Besides besides(const std::vector<Lane>& lanes, const std::vector<std::size_t>& walls) {
    std::vector<SegmentGrid::Line> lines;
    double widest = 0;
    for (const std::size_t i : walls) {
        lines.push_back({lanes[i].points, true});
        widest = std::max(widest, width_of(lanes[i]));
    }
    const SegmentGrid grid(lines, beads_apart * widest);
    Besides result(walls.size());
    for (std::size_t i = 0; i < walls.size(); ++i)
        for (const Vec2 point : even_samples(lanes[walls[i]]))
            for (const NearLine& near : grid.near(point)) {
                const double apart =
                    (width_of(lanes[walls[i]]) + width_of(lanes[walls[near.line]])) / 2;
                if (near.line == i || near.distance > beads_apart * apart) continue;
                Beside& beside = result[i][near.line];
                ++beside.count;
                beside.sum += near.distance;
            }
    return result;
}

bool all_round(const Besides& besides, std::size_t a, std::size_t b) {
    const auto there = besides[a].find(b), back = besides[b].find(a);
    if (there == besides[a].end() || back == besides[b].end()) return false;
    constexpr int enough = samples - 2;
    return there->second.count >= enough && back->second.count >= enough;
}

}  // namespace

std::vector<std::vector<std::size_t>> nested_walls(const std::vector<Lane>& lanes) {
    std::vector<std::size_t> walls;
    for (std::size_t i = 0; i < lanes.size(); ++i)
        if (is_wall(lanes[i])) walls.push_back(i);
    if (walls.empty()) return {};
    const Besides beside = besides(lanes, walls);
    std::vector<bool> used(walls.size(), false);
    std::vector<std::vector<std::size_t>> groups;
    const auto wind_from = [&](std::size_t first) {
        std::vector<std::size_t> group;
        for (std::optional<std::size_t> here = first; here;) {
            used[*here] = true;
            group.push_back(walls[*here]);
            std::optional<std::size_t> next;
            double nearest = 0;
            for (const auto& [other, near] : beside[*here]) {
                if (used[other] || !may_follow(lanes[walls[*here]], lanes[walls[other]])) continue;
                const double mean = near.sum / near.count;
                if (!all_round(beside, *here, other) || (next && mean >= nearest)) continue;
                next = other;
                nearest = mean;
            }
            here = next;
        }
        groups.push_back(std::move(group));
    };
    for (const Role role : {Role::outer_wall, Role::wall})
        for (std::size_t i = 0; i < walls.size(); ++i)
            if (!used[i] && lanes[walls[i]].role == role) wind_from(i);
    return groups;
}

}  // namespace bead
