#include "geom/along.h"

#include <algorithm>
#include <utility>

#include "core/expects.h"

namespace bead {

MeasuredLoop measured(Polyline loop) {
    BEAD_EXPECTS(!loop.empty());
    MeasuredLoop result;
    result.at.reserve(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        result.at.push_back(result.length);
        result.length += distance(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
    }
    result.points = std::move(loop);
    return result;
}

std::vector<MeasuredLoop> measured_loops(const Region& region) {
    std::vector<MeasuredLoop> loops;
    for (const Polygon& polygon : region) {
        loops.push_back(measured(polygon.outer));
        for (const Polyline& hole : polygon.holes) loops.push_back(measured(hole));
    }
    return loops;
}

Vec2 point_at(const MeasuredLoop& loop, double place) {
    if (loop.length <= 0) return loop.points.front();
    const double once =
        std::clamp(place - loop.length * std::floor(place / loop.length), 0.0, loop.length);
    const auto after = std::upper_bound(loop.at.begin(), loop.at.end(), once);
    const auto i = static_cast<std::size_t>(after - loop.at.begin()) - 1;
    const bool last = i + 1 == loop.points.size();
    const double span = (last ? loop.length : loop.at[i + 1]) - loop.at[i];
    return lerp(loop.points[i], loop.points[last ? 0 : i + 1],
                span > 0 ? (once - loop.at[i]) / span : 0.0);
}

Polyline way(const MeasuredLoop& loop, double from, double to) {
    const auto place_after = [&](double place) {
        return static_cast<std::size_t>(std::upper_bound(loop.at.begin(), loop.at.end(), place) -
                                        loop.at.begin());
    };
    const auto place_not_before = [&](double place) {
        return static_cast<std::size_t>(std::lower_bound(loop.at.begin(), loop.at.end(), place) -
                                        loop.at.begin());
    };
    const std::size_t first = place_after(from), end = place_not_before(to);
    const bool past_start = to < from;
    Polyline points;
    for (std::size_t i = first; i < (past_start ? loop.points.size() : end); ++i)
        points.push_back(loop.points[i]);
    for (std::size_t i = 0; past_start && i < end; ++i) points.push_back(loop.points[i]);
    return points;
}

}  // namespace bead
