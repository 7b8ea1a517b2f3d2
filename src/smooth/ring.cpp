#include "smooth/ring.h"

#include <algorithm>
#include <limits>

namespace bead {
namespace {

constexpr double same_place = 1e-7;  // mm
constexpr int marks = 48;

double once_round(const Ring& ring, double place) {
    const double rest = place - ring.length * std::floor(place / ring.length);
    return rest < ring.length ? rest : 0;
}

}  // namespace

Ring ring_of(Polyline points, std::vector<Flow> flows) {
    Ring ring{std::move(points), {}, std::move(flows), 0, {}};
    ring.at.reserve(ring.points.size());
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
        ring.at.push_back(ring.length);
        ring.length += distance(ring.points[i], ring.points[(i + 1) % ring.points.size()]);
    }
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

std::size_t segment_at(const Ring& ring, double place) {
    const auto after = std::ranges::upper_bound(ring.at, once_round(ring, place));
    return static_cast<std::size_t>(after - ring.at.begin()) - 1;
}

Vec2 point_at(const Ring& ring, double place) {
    const std::size_t i = segment_at(ring, place);
    const Vec2 a = ring.points[i], b = ring.points[(i + 1) % ring.points.size()];
    const double all = distance(a, b);
    return all > 0 ? lerp(a, b, std::min(1.0, (once_round(ring, place) - ring.at[i]) / all)) : a;
}

Vec2 direction_at(const Ring& ring, double place) {
    const std::size_t i = segment_at(ring, place);
    const Vec2 along = ring.points[(i + 1) % ring.points.size()] - ring.points[i];
    return along / length(along);
}

// First of even places all round, then of the segments beside the nearest of these.
double nearest_place(const Ring& ring, Vec2 point) {
    const double step = ring.length / marks;
    const auto mark = std::ranges::min_element(
        ring.marks, {}, [&](Vec2 at) { return dot(at - point, at - point); });
    const double near = static_cast<double>(mark - ring.marks.begin()) * step;
    const std::size_t n = ring.points.size();
    std::size_t segment = segment_at(ring, near - step);
    const std::size_t last = segment_at(ring, near + step);
    double place = near, best = std::numeric_limits<double>::infinity();
    for (std::size_t count = 0; count < n; ++count, segment = (segment + 1) % n) {
        const Vec2 a = ring.points[segment];
        const Vec2 along = ring.points[(segment + 1) % n] - a, to = point - a;
        const double t = std::clamp(dot(to, along) / dot(along, along), 0.0, 1.0);
        const double off = length(to - t * along);
        if (off < best) {
            best = off;
            place = ring.at[segment] + t * length(along);
        }
        if (segment == last) break;
    }
    return place;
}

void append_point(Ribbon& ribbon, Vec2 point, const Flow& flow) {
    if (!ribbon.points.empty()) {
        if (distance(ribbon.points.back(), point) <= same_place) return;
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
