#include "infill/principal_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bead {
namespace {

constexpr double agreement = 0.7;  // of the mean of four unit vectors; less: they disagree
constexpr double closing = 0.8;    // steps from the seed at which a line is closed
constexpr int shortest_loop = 20;  // steps

double half_difference(PlaneTensor t) { return std::hypot((t.xx - t.yy) / 2, t.xy); }

}  // namespace

PrincipalTracer::PrincipalTracer(TensorField field, const Region& region, TraceOptions options)
    : field_(std::move(field)), edges_(measured_loops(region)), options_(std::move(options)) {}

std::optional<Vec2> PrincipalTracer::way_at(Vec2 p, Vec2 before, PrincipalFamily family) const {
    const PlaneTensor t = field_(p);
    if (!(half_difference(t) > options_.isotropic * options_.scale)) return std::nullopt;
    const Vec2 way = direction(t, family);
    return dot(way, before) < 0 ? -way : way;
}

// The mean of the four stages: a chord over its arc, so a little less than one long. Made one long
// it would leave the line sideways and lose an order.
std::optional<Vec2> PrincipalTracer::runge_kutta(Vec2 p, Vec2 before, PrincipalFamily family,
                                                 double h) const {
    const auto k1 = way_at(p, before, family);
    if (!k1) return std::nullopt;
    const auto k2 = way_at(p + h / 2 * *k1, *k1, family);
    if (!k2) return std::nullopt;
    const auto k3 = way_at(p + h / 2 * *k2, *k2, family);
    if (!k3) return std::nullopt;
    const auto k4 = way_at(p + h * *k3, *k3, family);
    if (!k4) return std::nullopt;
    const Vec2 mean = (*k1 + 2 * *k2 + 2 * *k3 + *k4) / 6;
    if (length(mean) < agreement) return std::nullopt;
    return mean;
}

// The first place where a step meets the region's edge.
std::optional<Vec2> PrincipalTracer::crossing(Vec2 from, Vec2 to) const {
    const Vec2 low{std::min(from.x, to.x), std::min(from.y, to.y)};
    const Vec2 high{std::max(from.x, to.x), std::max(from.y, to.y)};
    const Vec2 way = to - from;
    double first = 2;
    edges_.for_each_near(low, high, [&](const Edge& edge) {
        const Vec2 side = edge.b - edge.a;
        const double turn = cross(way, side);
        if (turn == 0) return;
        const double t = cross(edge.a - from, side) / turn, s = cross(edge.a - from, way) / turn;
        if (t >= 0 && t <= 1 && s >= 0 && s <= 1) first = std::min(first, t);
    });
    if (first > 1) return std::nullopt;
    return lerp(from, to, first);
}

// Out of the region, or across a corner of it and in again.
bool PrincipalTracer::leaves(Vec2 from, Vec2 to) const {
    return !edges_.contains(to) || crossing(from, to);
}

// Where the line itself meets the edge: steps made shorter until they end on it.
Vec2 PrincipalTracer::end_on_edge(Vec2 at, Vec2 way, PrincipalFamily family) const {
    constexpr int halvings = 24;
    double inside = 0, outside = options_.step;
    Vec2 last = at, beyond = at + options_.step * way;
    for (int i = 0; i < halvings; ++i) {
        const double h = (inside + outside) / 2;
        const std::optional<Vec2> next_way = runge_kutta(at, way, family, h);
        const Vec2 next = at + h * next_way.value_or(way);
        const bool is_out = leaves(at, next);
        (is_out ? outside : inside) = h;
        (is_out ? beyond : last) = next;
    }
    return crossing(last, beyond).value_or(last);
}

PrincipalTracer::Half PrincipalTracer::half(Vec2 seed, Vec2 way, PrincipalFamily family) const {
    Half found;
    Vec2 at = seed;
    const int most = static_cast<int>(options_.longest / options_.step);
    for (int step = 1; step <= most; ++step) {
        const std::optional<Vec2> next_way = runge_kutta(at, way, family, options_.step);
        if (!next_way) {
            found.end = TraceEnd::isotropic;
            return found;
        }
        const Vec2 next = at + options_.step * *next_way;
        if (leaves(at, next)) {
            found.points.push_back(end_on_edge(at, *next_way, family));
            found.end = TraceEnd::boundary;
            return found;
        }
        if (options_.stop && options_.stop(next)) {
            found.end = TraceEnd::stopped;
            return found;
        }
        found.points.push_back(next);
        if (step > shortest_loop && distance(next, seed) < closing * options_.step) {
            found.points.push_back(seed);
            found.end = TraceEnd::closed;
            return found;
        }
        way = *next_way;
        at = next;
    }
    return found;
}

std::optional<TracedLine> PrincipalTracer::line(Vec2 seed, PrincipalFamily family) const {
    if (!edges_.contains(seed)) return std::nullopt;
    const PlaneTensor t = field_(seed);
    if (!(half_difference(t) > options_.isotropic * options_.scale)) return std::nullopt;
    const Vec2 way = direction(t, family);
    Half on = half(seed, way, family);
    TracedLine line;
    line.end = line.begin = on.end;
    if (on.end != TraceEnd::closed) {
        Half back = half(seed, -way, family);
        line.begin = back.end;
        line.points.assign(back.points.rbegin(), back.points.rend());
    }
    line.points.push_back(seed);
    line.points.insert(line.points.end(), on.points.begin(), on.points.end());
    return line;
}

}  // namespace bead
