#include "fem/stretch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/along.h"

namespace bead {
namespace {

constexpr double widest_chord = 0.8;  // rad; a longer side is no part of a circle
constexpr double same_corner = 0.01;  // mm

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

// The place on the loop that both ends are nearest to; nothing if none is near enough to both.
std::optional<std::pair<Place, Place>> ends_on_loop(const std::vector<MeasuredLoop>& loops,
                                                    const Stretch& stretch) {
    std::optional<std::pair<Place, Place>> best;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const Place from = nearest_on(loops[i], i, stretch.from);
        const Place to = nearest_on(loops[i], i, stretch.to);
        if (std::max(from.distance, to.distance) > boundary_tolerance) continue;
        if (best && from.distance + to.distance >= best->first.distance + best->second.distance)
            continue;
        best = {from, to};
    }
    return best;
}

// The shorter way.
std::optional<std::vector<BoundarySpan>> span_between(const std::vector<MeasuredLoop>& loops,
                                                      const Stretch& stretch) {
    const auto ends = ends_on_loop(loops, stretch);
    if (!ends) return std::nullopt;
    const std::size_t loop = ends->first.loop;
    const double around = loops[loop].length;
    double from = ends->first.at, to = ends->second.at;
    if (std::abs(to - from) < 1e-9) return {{{loop, from, from}}};
    if (to < from) to += around;
    if (to - from > around / 2) {
        std::swap(from, to);
        to += around;
        if (from >= around) {
            from -= around;
            to -= around;
        }
    }
    return {{{loop, from, to}}};
}

double angle_of(Vec2 v) { return std::atan2(v.y, v.x); }

// The parts of a side of the boundary, a chord of the circle, between the arc's angles, as shares.
std::vector<std::pair<double, double>> shares_of_chord(Vec2 a, Vec2 b, const CircleArc& arc) {
    std::vector<std::pair<double, double>> shares;
    const Vec2 centre = arc.circle.centre;
    const double begin = angle_of(a - centre);
    const double turn = std::atan2(cross(a - centre, b - centre), dot(a - centre, b - centre));
    if (std::abs(turn) > widest_chord || turn == 0) return shares;
    for (int k = -3; k <= 3; ++k) {
        double first = (arc.begin + 2 * pi * k - begin) / turn;
        double last = (arc.end + 2 * pi * k - begin) / turn;
        if (first > last) std::swap(first, last);
        first = std::max(first, 0.0);
        last = std::min(last, 1.0);
        if (last - first > 1e-9) shares.emplace_back(first, last);
    }
    return shares;
}

void append(std::vector<BoundarySpan>& spans, const BoundarySpan& next) {
    if (!spans.empty() && spans.back().loop == next.loop &&
        std::abs(spans.back().to - next.from) < 1e-9)
        spans.back().to = next.to;
    else
        spans.push_back(next);
}

// What ends at the loop's first point goes on with what begins there.
void join_round(std::vector<BoundarySpan>& spans, const MeasuredLoop& loop, std::size_t first) {
    if (spans.size() < first + 2) return;
    if (spans[first].from > 1e-9 || std::abs(spans.back().to - loop.length) > 1e-9) return;
    spans.back().to += spans[first].to;
    spans.erase(spans.begin() + std::ptrdiff_t(first));
}

std::optional<std::vector<BoundarySpan>> arc_spans(const std::vector<MeasuredLoop>& loops,
                                                   const CircleArc& arc) {
    std::vector<BoundarySpan> spans;
    const auto on_circle = [&](Vec2 p) {
        return std::abs(distance(p, arc.circle.centre) - arc.circle.radius) < boundary_tolerance;
    };
    for (std::size_t n = 0; n < loops.size(); ++n) {
        const MeasuredLoop& loop = loops[n];
        const std::size_t first_span = spans.size();
        for (std::size_t i = 0; i < loop.points.size(); ++i) {
            const Vec2 a = loop.points[i], b = loop.points[(i + 1) % loop.points.size()];
            if (!on_circle(a) || !on_circle(b)) continue;
            const double side = distance(a, b);
            for (const auto& [first, last] : shares_of_chord(a, b, arc))
                append(spans, {n, loop.at[i] + first * side, loop.at[i] + last * side});
        }
        join_round(spans, loop, first_span);
    }
    if (spans.empty()) return std::nullopt;
    return spans;
}

// A place that is a corner but for rounding is the corner: no mesh can follow the sliver between.
double snapped(const MeasuredLoop& loop, double at) {
    const double once = std::fmod(at, loop.length);
    const auto next = std::ranges::lower_bound(loop.at, once);
    const double above = next == loop.at.end() ? loop.length : *next;
    const double below = next == loop.at.begin() ? above : *(next - 1);
    const double nearest = std::abs(above - once) < std::abs(once - below) ? above : below;
    return std::abs(nearest - once) < same_corner ? at + (nearest - once) : at;
}

void snap_ends(BoundarySpan& span, const MeasuredLoop& loop) {
    const double from = snapped(loop, span.from), to = snapped(loop, span.to);
    const bool is_point = span.from == span.to;
    if (to > from || is_point) span = {span.loop, from, is_point ? from : to};
}

Polyline line_of(const MeasuredLoop& loop, const BoundarySpan& span) {
    Polyline line{point_at(loop, span.from)};
    for (const double turn : {0.0, loop.length})
        for (std::size_t i = 0; i < loop.points.size(); ++i)
            if (const double at = loop.at[i] + turn; at > span.from + 1e-9 && at < span.to - 1e-9)
                line.push_back(loop.points[i]);
    line.push_back(point_at(loop, span.to));
    return line;
}

}  // namespace

std::optional<std::vector<BoundarySpan>> stretch_spans(const Region& part, const Stretch& stretch) {
    const std::vector<MeasuredLoop> loops = measured_loops(part);
    auto spans = stretch.arc ? arc_spans(loops, *stretch.arc) : span_between(loops, stretch);
    if (spans)
        for (BoundarySpan& span : *spans) snap_ends(span, loops[span.loop]);
    return spans;
}

std::optional<std::vector<Polyline>> stretch_lines(const Region& part, const Stretch& stretch) {
    const auto spans = stretch_spans(part, stretch);
    if (!spans) return std::nullopt;
    const std::vector<MeasuredLoop> loops = measured_loops(part);
    std::vector<Polyline> lines;
    for (const BoundarySpan& span : *spans) lines.push_back(line_of(loops[span.loop], span));
    return lines;
}

Stretch moved(const Region& part, Stretch stretch, double distance) {
    if (stretch.arc) {
        stretch.arc->begin += distance / stretch.arc->circle.radius;
        stretch.arc->end += distance / stretch.arc->circle.radius;
        return stretch;
    }
    const std::vector<MeasuredLoop> loops = measured_loops(part);
    const auto ends = ends_on_loop(loops, stretch);
    if (!ends) return stretch;
    const MeasuredLoop& loop = loops[ends->first.loop];
    stretch.from = point_at(loop, ends->first.at + distance);
    stretch.to = point_at(loop, ends->second.at + distance);
    return stretch;
}

double traction(const Load& load, Vec2 point) {
    if (!load.bearing || !load.on.arc) return 1;
    const Vec2 out = point - load.on.arc->circle.centre;
    const double sizes = length(out) * length(load.force);
    return sizes > 0 ? std::max(0.0, dot(out, load.force) / sizes) : 0;
}

}  // namespace bead
