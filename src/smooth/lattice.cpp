#include "smooth/lattice.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/expects.h"
#include "geom/deviation.h"

namespace bead {
namespace {

void add_crossings(std::vector<double>& crossings, const Polyline& loop, double y) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const Vec2 a = loop[j], b = loop[i];
        if ((a.y > y) != (b.y > y))
            crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
}

// Where the region's boundary crosses this height, from left to right: inside between 1st and 2nd.
std::vector<double> crossings_at(const Region& region, double y) {
    std::vector<double> crossings;
    for (const Polygon& polygon : region) {
        add_crossings(crossings, polygon.outer, y);
        for (const Polyline& hole : polygon.holes) add_crossings(crossings, hole, y);
    }
    std::ranges::sort(crossings);
    return crossings;
}

struct Range {
    std::int64_t first, last;
};

Range between(double low, double high, double origin, double pitch, std::int64_t count) {
    return {std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil((low - origin) / pitch))),
            std::min<std::int64_t>(count - 1,
                                   static_cast<std::int64_t>(std::floor((high - origin) / pitch)))};
}

}  // namespace

Lattice::Lattice(const Region& region, double pitch) : pitch_(pitch) {
    BEAD_EXPECTS(pitch > 0);
    const Box2 box = bounds(region);
    if (box.is_empty()) return;
    // Not on the grid lines of round dimensions, where a wall may run.
    low_ = box.low + Vec2{0.37 * pitch, 0.41 * pitch};
    columns_ = static_cast<std::int64_t>(box.size().x / pitch) + 1;
    rows_ = static_cast<std::int64_t>(box.size().y / pitch) + 1;
    numbers_.assign(static_cast<std::size_t>(columns_ * rows_), 0);
    for (std::int64_t row = 0; row < rows_; ++row) {
        const auto crossings = crossings_at(region, low_.y + static_cast<double>(row) * pitch);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const Range in = between(crossings[i], crossings[i + 1], low_.x, pitch, columns_);
            for (std::int64_t column = in.first; column <= in.last; ++column)
                number(column, row) = static_cast<std::uint32_t>(++size_);
        }
    }
}

// Row by row, only the columns that the part of the segment near this row can reach.
template <class Visit>
void Lattice::for_each_near(Vec2 a, Vec2 b, double reach, const Visit& visit) const {
    if (a.y > b.y) std::swap(a, b);
    const Range high = between(a.y - reach, b.y + reach, low_.y, pitch_, rows_);
    for (std::int64_t row = high.first; row <= high.last; ++row) {
        const double y = low_.y + static_cast<double>(row) * pitch_;
        const auto x_at = [&](double height) {
            return b.y > a.y ? lerp(a, b, std::clamp((height - a.y) / (b.y - a.y), 0.0, 1.0)).x
                             : a.x;
        };
        const bool level = b.y - a.y <= 2 * reach;
        const double x0 = level ? a.x : x_at(y - reach), x1 = level ? b.x : x_at(y + reach);
        const Range wide =
            between(std::min(x0, x1) - reach, std::max(x0, x1) + reach, low_.x, pitch_, columns_);
        for (std::int64_t column = wide.first; column <= wide.last; ++column) {
            const std::uint32_t number =
                numbers_[static_cast<std::size_t>(row * columns_ + column)];
            if (number == 0) continue;
            const double away =
                segment_distance(a, b, {low_.x + static_cast<double>(column) * pitch_, y});
            if (away <= reach) visit(number - 1, static_cast<float>(away));
        }
    }
}

void Lattice::bring_near(std::vector<float>& nearest, const Polyline& line, double reach) const {
    for (std::size_t i = 1; i < line.size(); ++i)
        for_each_near(line[i - 1], line[i], reach, [&](std::uint32_t place, float away) {
            nearest[place] = std::min(nearest[place], away);
        });
}

std::vector<NearPlace> Lattice::near(const Polyline& line, double reach) const {
    std::vector<float> nearest(size_, std::numeric_limits<float>::infinity());
    std::vector<std::uint32_t> reached;
    for (std::size_t i = 1; i < line.size(); ++i)
        for_each_near(line[i - 1], line[i], reach, [&](std::uint32_t place, float away) {
            if (std::isinf(nearest[place])) reached.push_back(place);
            nearest[place] = std::min(nearest[place], away);
        });
    std::ranges::sort(reached);
    std::vector<NearPlace> places;
    places.reserve(reached.size());
    for (const std::uint32_t place : reached) places.push_back({place, nearest[place]});
    return places;
}

}  // namespace bead
