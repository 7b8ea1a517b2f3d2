#include "smooth/neighbourhood.h"

#include <algorithm>
#include <limits>

#include "core/expects.h"

namespace bead {
Neighbourhood::Neighbourhood(const std::vector<const Polyline*>& loops, double reach)
    : cell_(reach) {
    BEAD_EXPECTS(reach > 0);
    Box2 box;
    for (const Polyline* const loop : loops)
        for (const Vec2 point : *loop) box.include(point);
    if (box.is_empty()) box.include(Vec2{});
    // Two cells more than the reach on every side: a point counts for where it may have been cut.
    const Vec2 margin = 2 * reach * Vec2{1, 1};
    low_ = box.low - margin;
    const Vec2 size = box.high + margin - low_;
    cell_ = std::max(cell_, std::sqrt(size.x * size.y / most_cells));
    columns_ = static_cast<std::int64_t>(size.x / cell_) + 1;
    rows_ = static_cast<std::int64_t>(size.y / cell_) + 1;
    std::vector<std::uint32_t> last(static_cast<std::size_t>(columns_ * rows_),
                                    std::numeric_limits<std::uint32_t>::max());
    for (std::size_t i = 0; i < loops.size(); ++i)
        add(static_cast<std::uint32_t>(i), *loops[i], last);
    loops_ = sorted_by_cell(entries_, last.size());
    entries_ = {};
}

// At places half a cell apart or less, each for all that is within reach of anything beside it.
void Neighbourhood::add(std::uint32_t loop, const Polyline& points,
                        std::vector<std::uint32_t>& last) {
    Vec2 done = points.front() + Vec2{2 * cell_, 0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 a = points[i], b = points[i + 1 < points.size() ? i + 1 : 0];
        const int parts = 1 + static_cast<int>(2 * distance(a, b) / cell_);
        for (int k = 0; k < parts; ++k) {
            const Vec2 here = lerp(a, b, static_cast<double>(k) / parts);
            if (distance(done, here) < cell_ / 2) continue;
            add(loop, here, last);
            done = here;
        }
    }
}

// What lies within half a cell of this place reaches no farther than this many cells.
void Neighbourhood::add(std::uint32_t loop, Vec2 point, std::vector<std::uint32_t>& last) {
    constexpr std::int64_t reach = 2;
    const Vec2 p = point - low_;
    const auto column = static_cast<std::int64_t>(p.x / cell_);
    const auto row = static_cast<std::int64_t>(p.y / cell_);
    for (auto y = std::max<std::int64_t>(row - reach, 0); y <= std::min(row + reach, rows_ - 1);
         ++y)
        for (auto x = std::max<std::int64_t>(column - reach, 0);
             x <= std::min(column + reach, columns_ - 1); ++x) {
            const auto cell = static_cast<std::uint32_t>(y * columns_ + x);
            if (last[cell] == loop) continue;
            last[cell] = loop;
            entries_.push_back({cell, loop});
        }
}

std::span<const std::uint32_t> Neighbourhood::around(Vec2 point) const {
    const Vec2 p = point - low_;
    if (p.x < 0 || p.y < 0) return {};
    const auto column = static_cast<std::int64_t>(p.x / cell_);
    const auto row = static_cast<std::int64_t>(p.y / cell_);
    if (column >= columns_ || row >= rows_) return {};
    const auto cell = static_cast<std::size_t>(row * columns_ + column);
    return loops_.in(cell, cell);
}

}  // namespace bead
