#include "geom/line_index.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"

namespace bead {
namespace {

int whole(double value) { return static_cast<int>(std::floor(value)); }

}  // namespace

LineIndex::LineIndex(std::span<const Polyline> lines, double bucket) : bucket_(bucket) {
    BEAD_EXPECTS(bucket > 0);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        double along = 0;
        for (std::size_t k = 1; k < lines[i].size(); ++k) {
            segments_.push_back({lines[i][k - 1], lines[i][k], i, along});
            along += distance(lines[i][k - 1], lines[i][k]);
        }
        box_.include(bounds(lines[i]));
    }
    if (segments_.empty()) return;
    columns_ = whole(box_.size().x / bucket) + 1;
    rows_ = whole(box_.size().y / bucket) + 1;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
        const Vec2 a = (segments_[s].from - box_.low) / bucket;
        const Vec2 b = (segments_[s].to - box_.low) / bucket;
        for (int row = whole(std::min(a.y, b.y)); row <= whole(std::max(a.y, b.y)); ++row)
            for (int column = whole(std::min(a.x, b.x)); column <= whole(std::max(a.x, b.x));
                 ++column)
                pairs.emplace_back(bucket_at(column, row), s);
    }
    std::sort(pairs.begin(), pairs.end());
    starts_.assign(bucket_at(0, rows_) + 1, 0);
    for (const auto& [at, segment] : pairs) {
        ++starts_[at + 1];
        entries_.push_back(segment);
    }
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
}

std::size_t LineIndex::bucket_at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
}

std::optional<LineIndex::Near> LineIndex::nearest(Vec2 p, double reach) const {
    std::optional<Near> best;
    if (segments_.empty()) return best;
    const Vec2 low = (p - box_.low - Vec2{reach, reach}) / bucket_;
    const Vec2 high = (p - box_.low + Vec2{reach, reach}) / bucket_;
    double least = reach;
    for (int row = std::max(whole(low.y), 0); row <= std::min(whole(high.y), rows_ - 1); ++row)
        for (int column = std::max(whole(low.x), 0);
             column <= std::min(whole(high.x), columns_ - 1); ++column)
            for (std::size_t e = starts_[bucket_at(column, row)];
                 e < starts_[bucket_at(column, row) + 1]; ++e) {
                const Segment& s = segments_[entries_[e]];
                const Vec2 way = s.to - s.from;
                const double square = dot(way, way);
                const double t =
                    square > 0 ? std::clamp(dot(p - s.from, way) / square, 0.0, 1.0) : 0;
                const Vec2 at = s.from + t * way;
                const double away = distance(p, at);
                if (away >= least) continue;
                least = away;
                best = Near{s.line, s.along + t * std::sqrt(square), away, at};
            }
    return best;
}

}  // namespace bead
