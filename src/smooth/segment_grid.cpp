#include "smooth/segment_grid.h"

#include <algorithm>
#include <limits>

#include "geom/deviation.h"

namespace bead {
namespace {

std::int64_t index_of(double along, double cell) {
    return static_cast<std::int64_t>(std::floor(along / cell));
}

Box2 box_of(const std::vector<SegmentGrid::Line>& lines) {
    Box2 box;
    for (const SegmentGrid::Line& line : lines)
        for (const Vec2 point : line.points) box.include(point);
    if (box.is_empty()) box.include(Vec2{});
    return box;
}

bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const auto side = [](Vec2 from, Vec2 to, Vec2 p) { return cross(to - from, p - from); };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

}  // namespace

SegmentGrid::SegmentGrid(const std::vector<Line>& lines, double reach, double cell)
    : reach_(reach), cell_(cell > 0 ? cell : reach) {
    const Box2 box = box_of(lines);
    const Vec2 size = box.size();
    cell_ = std::max(cell_, std::sqrt(size.x * size.y / most_cells));
    cell_ = std::max(cell_, (size.x + size.y) / most_cells);
    low_ = box.low;
    columns_ = index_of(size.x, cell_) + 1;
    rows_ = index_of(size.y, cell_) + 1;
    std::size_t count = 0;
    for (const Line& line : lines) count += line.points.size();
    segments_.reserve(count);
    std::vector<CellEntry> entries;
    entries.reserve(2 * count);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::span<const Vec2> points = lines[i].points;
        const auto number = static_cast<std::uint32_t>(i);
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
            add(number, points[k], points[k + 1], entries);
        if (lines[i].closed && !points.empty()) add(number, points.back(), points.front(), entries);
    }
    numbers_ = sorted_by_cell(entries, static_cast<std::size_t>(columns_ * rows_));
}

// Long segments in steps, so that a slanted one is not in all the cells of its box.
void SegmentGrid::add(std::uint32_t line, Vec2 a, Vec2 b, std::vector<CellEntry>& entries) {
    const auto number = static_cast<std::uint32_t>(segments_.size());
    segments_.push_back({a, b, line});
    const auto parts = static_cast<int>(distance(a, b) / cell_) + 1;
    const std::size_t first = entries.size();
    for (int i = 0; i < parts; ++i) {
        const Vec2 p = lerp(a, b, static_cast<double>(i) / parts) - low_;
        const Vec2 q = lerp(a, b, (i + 1.0) / parts) - low_;
        const std::int64_t right = std::min(index_of(std::max(p.x, q.x), cell_), columns_ - 1);
        const std::int64_t top = std::min(index_of(std::max(p.y, q.y), cell_), rows_ - 1);
        for (auto y = std::max<std::int64_t>(index_of(std::min(p.y, q.y), cell_), 0); y <= top; ++y)
            for (auto x = std::max<std::int64_t>(index_of(std::min(p.x, q.x), cell_), 0);
                 x <= right; ++x) {
                const auto cell = static_cast<std::uint32_t>(y * columns_ + x);
                const bool again = entries.size() > first && entries.back().cell == cell;
                if (!again) entries.push_back({cell, number});
            }
    }
}

SegmentGrid::Cells SegmentGrid::cells_around(Vec2 point, double distance) const {
    const Vec2 p = point - low_;
    return {std::max<std::int64_t>(index_of(p.x - distance, cell_), 0),
            std::min(index_of(p.x + distance, cell_), columns_ - 1),
            std::max<std::int64_t>(index_of(p.y - distance, cell_), 0),
            std::min(index_of(p.y + distance, cell_), rows_ - 1)};
}

template <class Visit>
bool SegmentGrid::visit(const Cells& cells, const Visit& visitor) const {
    if (cells.left > cells.right) return true;
    for (auto y = cells.bottom; y <= cells.top; ++y) {
        const auto row = static_cast<std::size_t>(y * columns_);
        const auto left = row + static_cast<std::size_t>(cells.left);
        const auto right = row + static_cast<std::size_t>(cells.right);
        for (const std::uint32_t i : numbers_.in(left, right))
            if (!visitor(segments_[i])) return false;
    }
    return true;
}

std::vector<NearLine> SegmentGrid::near(Vec2 point) const {
    std::vector<NearLine> result;
    visit(cells_around(point, reach_), [&](const Segment& segment) {
        const double square = squared_segment_distance(segment.a, segment.b, point);
        if (square > reach_ * reach_) return true;
        const auto known = std::ranges::find(result, segment.line, &NearLine::line);
        if (known == result.end())
            result.push_back({segment.line, square});
        else
            known->distance = std::min(known->distance, square);
        return true;
    });
    for (NearLine& near : result) near.distance = std::sqrt(near.distance);
    std::ranges::sort(result, {}, &NearLine::line);
    return result;
}

// In growing squares: what is within a square's half side is in its cells.
std::optional<double> SegmentGrid::nearest_other(Vec2 point, std::size_t line) const {
    double least = std::numeric_limits<double>::infinity();
    for (double half = std::min(cell_, reach_);; half = std::min(2 * half, reach_)) {
        visit(cells_around(point, half), [&](const Segment& segment) {
            if (segment.line != line)
                least = std::min(least, squared_segment_distance(segment.a, segment.b, point));
            return true;
        });
        if (least <= half * half) return std::sqrt(least);
        if (half >= reach_) return {};
    }
}

bool SegmentGrid::is_clear(Vec2 point, double distance, std::array<std::size_t, 2> but) const {
    return visit(cells_around(point, distance), [&](const Segment& segment) {
        return segment.line == but[0] || segment.line == but[1] ||
               squared_segment_distance(segment.a, segment.b, point) >= distance * distance;
    });
}

// In steps of a cell, each with what is around its middle.
bool SegmentGrid::is_crossed(Vec2 a, Vec2 b) const {
    const auto parts = static_cast<int>(distance(a, b) / cell_) + 1;
    const double half = distance(a, b) / parts / 2;
    for (int i = 0; i < parts; ++i)
        if (!visit(cells_around(lerp(a, b, (i + 0.5) / parts), half), [&](const Segment& segment) {
                return !cross_each_other(a, b, segment.a, segment.b);
            }))
            return true;
    return false;
}

}  // namespace bead
