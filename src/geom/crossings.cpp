#include "geom/crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bead {
namespace {

// The share of ab at which it crosses pq.
std::optional<double> share_crossed(Vec2 a, Vec2 b, Vec2 p, Vec2 q) {
    const double from = cross(q - p, a - p), to = cross(q - p, b - p);
    if ((from > 0) == (to > 0)) return std::nullopt;
    if ((cross(b - a, p - a) > 0) == (cross(b - a, q - a) > 0)) return std::nullopt;
    return from / (from - to);
}

}  // namespace

Crossings::Crossings(std::span<const Polyline> lines) {
    for (const Polyline& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Vec2 a = line[i - 1], b = line[i];
            sides_.push_back({a, b, std::min(a.x, b.x)});
            widest_ = std::max(widest_, std::abs(b.x - a.x));
        }
    std::ranges::stable_sort(sides_, {}, &Side::low);
}

std::vector<double> Crossings::on(const Polyline& line) const {
    std::vector<double> places;
    double before = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec2 a = line[i - 1], b = line[i];
        const double high = std::max(a.x, b.x);
        auto side = std::ranges::lower_bound(sides_, std::min(a.x, b.x) - widest_, {}, &Side::low);
        for (; side != sides_.end() && side->low <= high; ++side)
            if (const auto share = share_crossed(a, b, side->from, side->to))
                places.push_back(before + *share * distance(a, b));
        before += distance(a, b);
    }
    std::ranges::sort(places);
    return places;
}

}  // namespace bead
