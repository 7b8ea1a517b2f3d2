#include "smooth/segment_grid.h"

#include <algorithm>

#include "geom/deviation.h"

namespace bead {
namespace {

constexpr double most_cells = 4e6;

std::int64_t index_of(double along, double cell) {
    return static_cast<std::int64_t>(std::floor(along / cell));
}

}  // namespace

SegmentGrid::SegmentGrid(const std::vector<Line>& lines, double reach) : reach_(reach) {
    Polyline corners;
    for (const Line& line : lines) {
        const Box2 box = bounds(line.points);
        corners.push_back(box.low);
        corners.push_back(box.high);
    }
    if (corners.empty()) corners.emplace_back();
    const Box2 box = bounds(corners);
    const Vec2 size = box.high - box.low;
    reach_ = std::max(reach, std::sqrt(size.x * size.y / most_cells));
    reach_ = std::max(reach_, (size.x + size.y) / most_cells);
    low_ = box.low;
    columns_ = index_of(size.x, reach_) + 1;
    rows_ = index_of(size.y, reach_) + 1;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::span<const Vec2> points = lines[i].points;
        const auto number = static_cast<std::uint32_t>(i);
        for (std::size_t k = 0; k + 1 < points.size(); ++k) add(number, points[k], points[k + 1]);
        if (lines[i].closed) add(number, points.back(), points.front());
    }
    std::ranges::stable_sort(segments_, {}, &Segment::cell);
    starts_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    for (const Segment& segment : segments_) ++starts_[segment.cell + 1];
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
}

std::uint64_t SegmentGrid::cell(std::int64_t column, std::int64_t row) const {
    return static_cast<std::uint64_t>(row * columns_ + column);
}

// Long segments in steps, so that a slanted one is not in all the cells of its box.
void SegmentGrid::add(std::uint32_t line, Vec2 a, Vec2 b) {
    const auto parts = static_cast<int>(distance(a, b) / reach_) + 1;
    for (int i = 0; i < parts; ++i) {
        const Vec2 p = lerp(a, b, static_cast<double>(i) / parts) - low_;
        const Vec2 q = lerp(a, b, (i + 1.0) / parts) - low_;
        for (auto y = index_of(std::min(p.y, q.y), reach_);
             y <= index_of(std::max(p.y, q.y), reach_); ++y)
            for (auto x = index_of(std::min(p.x, q.x), reach_);
                 x <= index_of(std::max(p.x, q.x), reach_); ++x)
                if (x >= 0 && y >= 0 && x < columns_ && y < rows_)
                    segments_.push_back({cell(x, y), line, p + low_, q + low_});
    }
}

std::vector<NearLine> SegmentGrid::near(Vec2 point) const {
    std::vector<NearLine> result;
    const Vec2 p = point - low_;
    const std::int64_t column = index_of(p.x, reach_), row = index_of(p.y, reach_);
    for (auto y = std::max<std::int64_t>(row - 1, 0); y <= std::min(row + 1, rows_ - 1); ++y)
        for (auto x = std::max<std::int64_t>(column - 1, 0);
             x <= std::min(column + 1, columns_ - 1); ++x)
            for (std::size_t i = starts_[cell(x, y)]; i < starts_[cell(x, y) + 1]; ++i) {
                const Segment& segment = segments_[i];
                const double away = segment_distance(segment.a, segment.b, point);
                if (away > reach_) continue;
                const auto known = std::ranges::find(result, segment.line, &NearLine::line);
                if (known == result.end())
                    result.push_back({segment.line, away});
                else
                    known->distance = std::min(known->distance, away);
            }
    std::ranges::sort(result, {}, &NearLine::line);
    return result;
}

}  // namespace bead
