#include "fem/stretch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/along.h"

namespace bead {
namespace {

constexpr double widest_chord = 0.8;  // rad; a longer side is no part of a circle

struct Place {
    std::size_t loop = 0;
    double at = 0;
    double distance = std::numeric_limits<double>::infinity();
};

Place nearest_on(const MeasuredLoop& loop, std::size_t number, Vec2 p) {
    Place best;
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
        const Vec2 a = loop.points[i], side = loop.points[(i + 1) % loop.points.size()] - a;
        const double size = dot(side, side);
        const double t = size > 0 ? std::clamp(dot(p - a, side) / size, 0.0, 1.0) : 0;
        const double far = distance(p, a + t * side);
        if (far < best.distance) best = {number, loop.at[i] + t * length(side), far};
    }
    if (best.at >= loop.length) best.at = 0;
    return best;
}

Polyline line_between(const MeasuredLoop& loop, double from, double to) {
    Polyline line{point_at(loop, from)};
    const Polyline between = way(loop, from, to);
    line.insert(line.end(), between.begin(), between.end());
    line.push_back(point_at(loop, to));
    return line;
}

// On the loop that both ends are nearest to, the shorter way.
std::optional<std::vector<Polyline>> line_of(const Region& part, const Stretch& stretch) {
    const std::vector<MeasuredLoop> loops = measured_loops(part);
    std::optional<std::pair<Place, Place>> best;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const Place from = nearest_on(loops[i], i, stretch.from);
        const Place to = nearest_on(loops[i], i, stretch.to);
        if (std::max(from.distance, to.distance) > boundary_tolerance) continue;
        if (best && from.distance + to.distance >= best->first.distance + best->second.distance)
            continue;
        best = {from, to};
    }
    if (!best) return std::nullopt;
    const MeasuredLoop& loop = loops[best->first.loop];
    double from = best->first.at, to = best->second.at;
    if (std::abs(to - from) < 1e-9) return {{{point_at(loop, from), point_at(loop, from)}}};
    const double forward = to > from ? to - from : to - from + loop.length;
    if (forward > loop.length / 2) std::swap(from, to);
    return {{line_between(loop, from, to)}};
}

double angle_of(Vec2 v) { return std::atan2(v.y, v.x); }

// The part of a side of the boundary, a chord of the circle, between the arc's angles.
void append_chord(Vec2 a, Vec2 b, const Arc& arc, std::vector<Polyline>& lines) {
    const Vec2 centre = arc.circle.centre;
    const double begin = angle_of(a - centre);
    const double turn = std::atan2(cross(a - centre, b - centre), dot(a - centre, b - centre));
    if (std::abs(turn) > widest_chord || turn == 0) return;
    for (int k = -2; k <= 2; ++k) {
        const double low = arc.begin + 2 * pi * k - begin, high = arc.end + 2 * pi * k - begin;
        double first = low / turn, last = high / turn;
        if (first > last) std::swap(first, last);
        first = std::max(first, 0.0);
        last = std::min(last, 1.0);
        if (last - first < 1e-9) continue;
        const Vec2 from = lerp(a, b, first), to = lerp(a, b, last);
        if (!lines.empty() && distance(lines.back().back(), from) < 1e-9)
            lines.back().push_back(to);
        else
            lines.push_back({from, to});
    }
}

std::optional<std::vector<Polyline>> arc_lines(const Region& part, const Arc& arc) {
    std::vector<Polyline> lines;
    const auto on_circle = [&](Vec2 p) {
        return std::abs(distance(p, arc.circle.centre) - arc.circle.radius) < boundary_tolerance;
    };
    for (const MeasuredLoop& loop : measured_loops(part))
        for (std::size_t i = 0; i < loop.points.size(); ++i) {
            const Vec2 a = loop.points[i], b = loop.points[(i + 1) % loop.points.size()];
            if (on_circle(a) && on_circle(b)) append_chord(a, b, arc, lines);
        }
    if (lines.empty()) return std::nullopt;
    return lines;
}

}  // namespace

std::optional<std::vector<Polyline>> stretch_lines(const Region& part, const Stretch& stretch) {
    return stretch.arc ? arc_lines(part, *stretch.arc) : line_of(part, stretch);
}

Stretch moved(const Region& part, Stretch stretch, double distance) {
    if (stretch.arc) {
        stretch.arc->begin += distance / stretch.arc->circle.radius;
        stretch.arc->end += distance / stretch.arc->circle.radius;
        return stretch;
    }
    const std::vector<MeasuredLoop> loops = measured_loops(part);
    std::pair<Place, Place> best;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const Place from = nearest_on(loops[i], i, stretch.from);
        const Place to = nearest_on(loops[i], i, stretch.to);
        if (from.distance + to.distance < best.first.distance + best.second.distance)
            best = {from, to};
    }
    if (best.first.loop >= loops.size()) return stretch;
    const MeasuredLoop& loop = loops[best.first.loop];
    stretch.from = point_at(loop, best.first.at + distance + loop.length);
    stretch.to = point_at(loop, best.second.at + distance + loop.length);
    return stretch;
}

double traction(const Load& load, Vec2 point) {
    if (!load.bearing || !load.on.arc) return 1;
    const Vec2 out = point - load.on.arc->circle.centre;
    const double sizes = length(out) * length(load.force);
    return sizes > 0 ? std::max(0.0, dot(out, load.force) / sizes) : 0;
}

}  // namespace bead
