#include "smooth/ring.h"

#include <algorithm>
#include <limits>

namespace bead {
namespace {

constexpr double least_apart = 1e-7;  // mm; nearer points of a ribbon are one
constexpr int marks = 48;

double once_round(const Ring& ring, double place) {
    const double rest = place - ring.length * std::floor(place / ring.length);
    return rest < ring.length ? rest : 0;
}

}  // namespace

Ring ring_of(Polyline points, std::vector<Flow> flows) {
    Ring ring{std::move(points), {}, std::move(flows), 0, {}, {}};
    const std::size_t n = ring.points.size();
    ring.at.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        ring.at.push_back(ring.length);
        ring.length += distance(ring.points[i], ring.points[i + 1 < n ? i + 1 : 0]);
    }
    ring.hints.reserve(n);
    std::uint32_t segment = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double place = ring.length * static_cast<double>(i) / static_cast<double>(n);
        while (segment + 1 < n && ring.at[segment + 1] <= place) ++segment;
        ring.hints.push_back(segment);
    }
    ring.marks.reserve(marks);
    for (int i = 0; i < marks; ++i) ring.marks.push_back(point_at(ring, ring.length * i / marks));
    return ring;
}

Ring reversed(const Ring& ring) {
    Polyline points(ring.points.rbegin(), ring.points.rend());
    std::vector<Flow> flows(ring.flows.rbegin(), ring.flows.rend());
    std::rotate(flows.begin(), flows.begin() + 1,
                flows.end());  // the closing segment stays the closing one
    return ring_of(std::move(points), std::move(flows));
}

namespace {

// The last segment that begins at or before the place, which lies on the first turn.
std::size_t segment_from(const Ring& ring, double place) {
    const std::size_t n = ring.at.size();
    const auto hint = static_cast<std::size_t>(place / ring.length * static_cast<double>(n));
    std::size_t i = ring.hints[std::min(hint, n - 1)];
    while (i > 0 && ring.at[i] > place) --i;
    while (i + 1 < n && ring.at[i + 1] <= place) ++i;
    return i;
}

}  // namespace

std::size_t segment_at(const Ring& ring, double place) {
    return segment_from(ring, once_round(ring, place));
}

RingSpot spot_at(const Ring& ring, double place) {
    const double rest = once_round(ring, place);
    const std::size_t i = segment_from(ring, rest);
    const Vec2 a = ring.points[i], along = ring.points[i + 1 < ring.points.size() ? i + 1 : 0] - a;
    const double all = length(along);
    const Vec2 point = all > 0 ? a + std::min(1.0, (rest - ring.at[i]) / all) * along : a;
    return {point, along / all};
}

Vec2 point_at(const Ring& ring, double place) { return spot_at(ring, place).point; }

Vec2 direction_at(const Ring& ring, double place) { return spot_at(ring, place).along; }

namespace {

std::size_t nearest_mark(const Ring& ring, Vec2 point) {
    std::size_t mark = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.marks.size(); ++i) {
        const Vec2 to = ring.marks[i] - point;
        if (dot(to, to) >= least) continue;
        least = dot(to, to);
        mark = i;
    }
    return mark;
}

// Of the segments from this one on, how many end within `way` of its start; not the ring's last.
std::size_t segments_within(const Ring& ring, std::size_t segment, double way) {
    const double end = ring.at[segment] + way;
    std::size_t after = segment;
    while (after + 1 < ring.at.size() && ring.at[after + 1] <= end) ++after;
    return after - segment;
}

}  // namespace

// First of even places all round, then of the segments beside the nearest of these. Nothing within
// x mm along from where it is x mm farther than there need be looked at.
double nearest_place(const Ring& ring, Vec2 point) {
    const double step = ring.length / marks;
    const std::size_t mark = nearest_mark(ring, point);
    const double near = static_cast<double>(mark) * step;
    const std::size_t n = ring.points.size(), first = segment_at(ring, near - step);
    const std::size_t count = (segment_at(ring, near + step) + n - first) % n + 1;
    double place = near, best = distance(ring.marks[mark], point) + least_apart;
    for (std::size_t i = 0; i < count;) {
        const std::size_t segment = first + i < n ? first + i : first + i - n;
        const Vec2 a = ring.points[segment], to = point - a;
        const double rest = length(to) - best;
        const std::size_t skipped = rest > 0 ? segments_within(ring, segment, rest) : 0;
        i += std::max<std::size_t>(skipped, 1);
        if (skipped > 0) continue;
        const Vec2 along = ring.points[segment + 1 < n ? segment + 1 : 0] - a;
        const double t = std::clamp(dot(to, along) / dot(along, along), 0.0, 1.0);
        const double off = length(to - t * along);
        if (off >= best) continue;
        best = off;
        place = ring.at[segment] + t * length(along);
    }
    return place;
}

void append_point(Ribbon& ribbon, Vec2 point, const Flow& flow) {
    if (!ribbon.points.empty()) {
        if (distance(ribbon.points.back(), point) <= least_apart) return;
        ribbon.flows.push_back(flow);
    }
    ribbon.points.push_back(point);
}

void append_way(Ribbon& ribbon, const Ring& ring, double from, double to) {
    std::size_t segment = segment_at(ring, from);
    const std::size_t n = ring.points.size();
    append_point(ribbon, point_at(ring, from), ring.flows[segment]);
    double turn = ring.length * std::floor(from / ring.length);
    for (;;) {
        const Flow flow = ring.flows[segment];
        if (++segment == n) {
            segment = 0;
            turn += ring.length;
        }
        if (turn + ring.at[segment] >= to) {
            append_point(ribbon, point_at(ring, to), flow);
            return;
        }
        append_point(ribbon, ring.points[segment], flow);
    }
}

double length(const Ribbon& ribbon) { return length(ribbon.points); }

double volume(const Ribbon& ribbon) {
    double sum = 0;
    for (std::size_t i = 0; i < ribbon.flows.size(); ++i)
        sum += ribbon.flows[i].section * distance(ribbon.points[i], ribbon.points[i + 1]);
    return sum;
}

}  // namespace bead
