#include "infill/edge_seeds.h"

#include <cmath>

#include "geom/along.h"

namespace bead {
namespace {

constexpr double corner = 0.35;  // rad; an edge that turns more has a corner there

double turn_at(const MeasuredLoop& loop, std::size_t i) {
    const std::size_t n = loop.points.size();
    const Vec2 at = loop.points[i];
    const Vec2 before = at - loop.points[(i + n - 1) % n], after = loop.points[(i + 1) % n] - at;
    return std::atan2(cross(before, after), dot(before, after));
}

Vec2 way_at(const MeasuredLoop& loop, double place) {
    constexpr double near = 0.01;  // mm
    const Vec2 way = point_at(loop, place + near) - point_at(loop, place - near);
    return way / length(way);
}

// Half a distance from the middle, then one more each time, both ways.
void append(std::vector<EdgeSeed>& seeds, const MeasuredLoop& loop, double from, double to,
            double apart) {
    const double middle = (from + to) / 2, half = (to - from) / 2;
    for (double off = apart / 2; off < half; off += apart)
        for (const double sign : {-1.0, 1.0}) {
            const double place = middle + sign * off;
            seeds.push_back({point_at(loop, place), way_at(loop, place)});
        }
}

}  // namespace

std::vector<EdgeSeed> edge_seeds(const Region& region, double apart) {
    std::vector<EdgeSeed> seeds;
    for (const MeasuredLoop& loop : measured_loops(region)) {
        std::vector<double> corners;
        for (std::size_t i = 0; i < loop.points.size(); ++i)
            if (std::abs(turn_at(loop, i)) > corner) corners.push_back(loop.at[i]);
        if (corners.empty()) corners.push_back(0);
        corners.push_back(corners.front() + loop.length);
        for (std::size_t i = 0; i + 1 < corners.size(); ++i)
            append(seeds, loop, corners[i], corners[i + 1], apart);
    }
    return seeds;
}

}  // namespace bead
