#include "fem/boundary_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geom/clip.h"

namespace bead {
namespace {

constexpr double same_place = 0.02;  // of an element's size: breaks so near are one
constexpr double on_circle = 0.01;   // mm
constexpr double straight = 1e-4;    // rad

// A sharp turn, or a slight one between sides that are longer than elements: no curve then.
bool is_corner(const MeasuredLoop& loop, std::size_t i, const SizeField& sizes) {
    const double turn = std::abs(turn_at(loop, i));
    if (turn > corner_turn) return true;
    const std::size_t n = loop.points.size();
    const Vec2 p = loop.points[i];
    const double shorter =
        std::min(distance(loop.points[(i + n - 1) % n], p), distance(p, loop.points[(i + 1) % n]));
    return turn > straight && shorter > sizes.at(p);
}

// Corners and ends of stretches on one loop, in its order; never none.
std::vector<double> breaks_of(const MeasuredLoop& loop, std::size_t number,
                              const std::vector<BoundarySpan>& stretches, const SizeField& sizes) {
    std::vector<double> breaks;
    for (std::size_t i = 0; i < loop.points.size(); ++i)
        if (is_corner(loop, i, sizes)) breaks.push_back(loop.at[i]);
    for (const BoundarySpan& span : stretches) {
        if (span.loop != number) continue;
        for (const double end : {span.from, span.to}) breaks.push_back(std::fmod(end, loop.length));
    }
    std::ranges::sort(breaks);
    const auto same = [&](double a, double b) {
        return b - a < std::min(0.1 * loop.length, same_place * sizes.at(point_at(loop, a)));
    };
    breaks.erase(std::unique(breaks.begin(), breaks.end(), same), breaks.end());
    while (breaks.size() > 1 && same(breaks.back(), breaks.front() + loop.length))
        breaks.pop_back();
    if (breaks.empty()) breaks.push_back(0);
    return breaks;
}

// Places that divide [from, to) so that each piece is about as long as the size asks there.
std::vector<double> divided(const MeasuredLoop& loop, double from, double to,
                            const SizeField& sizes) {
    const double finest = (to - from) / 400;
    std::vector<double> sum{0}, place{from};
    while (place.back() < to - 1e-9) {
        const double here = place.back();
        const double size = sizes.at(point_at(loop, here));
        const double next = std::min(to, here + std::max(finest, size / 8));
        sum.push_back(sum.back() + (next - here) / sizes.at(point_at(loop, (here + next) / 2)));
        place.push_back(next);
    }
    const int pieces = std::max(1, int(std::lround(sum.back())));
    std::vector<double> result;
    std::size_t k = 0;
    for (int i = 0; i < pieces; ++i) {
        const double wanted = sum.back() * i / pieces;
        while (k + 1 < sum.size() - 1 && sum[k + 1] <= wanted) ++k;
        const double t = (wanted - sum[k]) / (sum[k + 1] - sum[k]);
        result.push_back(place[k] + t * (place[k + 1] - place[k]));
    }
    return result;
}

}  // namespace

Vec2 Boundary::on_curve(std::size_t loop, double at) const {
    const Vec2 p = point_at(loops[loop], at);
    for (const Circle& circle : circles) {
        const Vec2 out = p - circle.centre;
        if (std::abs(length(out) - circle.radius) < on_circle)
            return circle.centre + circle.radius / length(out) * out;
    }
    return p;
}

void Boundary::halve(std::size_t side) {
    const auto [a, b] = sides[side];
    const BoundaryPoint& from = points[std::size_t(a)];
    double to = points[std::size_t(b)].at;
    if (to <= from.at) to += loops[from.loop].length;
    const double middle = (from.at + to) / 2;
    const double once = std::fmod(middle, loops[from.loop].length);
    points.push_back({on_curve(from.loop, middle), from.loop, once});
    const int place = int(points.size()) - 1;
    sides[side] = {a, place};
    sides.emplace_back(place, b);
}

Region Boundary::region() const {
    std::vector<int> next(points.size(), -1);
    for (const auto& [a, b] : sides) next[std::size_t(a)] = b;
    std::vector<Polyline> outlines;
    for (std::size_t i = 0; i < next.size(); ++i) {
        if (next[i] < 0) continue;
        outlines.emplace_back();
        for (int at = int(i); next[std::size_t(at)] >= 0;) {
            outlines.back().push_back(points[std::size_t(at)].place);
            at = std::exchange(next[std::size_t(at)], -1);
        }
    }
    return region_of(outlines, FillRule::even_odd);
}

Boundary boundary_of(std::vector<MeasuredLoop> loops, std::vector<Circle> circles,
                     const std::vector<BoundarySpan>& stretches, const SizeField& sizes) {
    Boundary boundary{std::move(loops), std::move(circles), {}, {}};
    for (std::size_t n = 0; n < boundary.loops.size(); ++n) {
        const MeasuredLoop& loop = boundary.loops[n];
        const std::vector<double> breaks = breaks_of(loop, n, stretches, sizes);
        const int first = int(boundary.points.size());
        for (std::size_t k = 0; k < breaks.size(); ++k) {
            const double to = k + 1 < breaks.size() ? breaks[k + 1] : breaks.front() + loop.length;
            for (const double at : divided(loop, breaks[k], to, sizes))
                boundary.points.push_back(
                    {boundary.on_curve(n, at), n, std::fmod(at, loop.length)});
        }
        const int end = int(boundary.points.size());
        for (int i = first; i < end; ++i)
            boundary.sides.emplace_back(i, i + 1 < end ? i + 1 : first);
    }
    return boundary;
}

}  // namespace bead
