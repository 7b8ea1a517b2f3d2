#include "smooth/segment_lattice.h"

#include <algorithm>
#include <limits>

#include "geom/deviation.h"

namespace bead {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

}  // namespace

SegmentLattice::SegmentLattice(std::span<const Polyline> lines, double cell) : cell_(cell) {
    for (const Polyline& line : lines) {
        box_.include(bounds(line));
        for (std::size_t i = 1; i < line.size(); ++i) segments_.push_back({line[i - 1], line[i]});
    }
    if (segments_.empty()) return;
    const Vec2 size = box_.size();
    cell_ = std::max(cell_, std::sqrt(size.x * size.y / most_cells));
    columns_ = static_cast<std::int64_t>(size.x / cell_) + 1;
    rows_ = static_cast<std::int64_t>(size.y / cell_) + 1;
    std::vector<CellEntry> entries;
    for (std::size_t i = 0; i < segments_.size(); ++i)
        for_each_cell(segments_[i], [&](std::size_t at) {
            entries.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(i)});
        });
    numbers_ = sorted_by_cell(entries, static_cast<std::size_t>(columns_ * rows_));
}

std::int64_t SegmentLattice::column(double x) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>((x - box_.low.x) / cell_), 0,
                                    columns_ - 1);
}

std::int64_t SegmentLattice::row(double y) const {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>((y - box_.low.y) / cell_), 0,
                                    rows_ - 1);
}

// All cells that the segment touches, row by row; of a slanted one a few beside them.
template <class Visit>
void SegmentLattice::for_each_cell(const Segment& segment, const Visit& visit) const {
    const auto [low, high] = std::minmax({segment.a.y, segment.b.y});
    const Vec2 along = segment.b - segment.a;
    for (std::int64_t r = row(low); r <= row(high); ++r) {
        double from = 0, to = 1;
        if (along.y != 0) {
            const double bottom = box_.low.y + static_cast<double>(r) * cell_;
            const double t1 = (bottom - segment.a.y) / along.y;
            const double t2 = (bottom + cell_ - segment.a.y) / along.y;
            from = std::clamp(std::min(t1, t2), 0.0, 1.0);
            to = std::clamp(std::max(t1, t2), 0.0, 1.0);
        }
        const double x1 = segment.a.x + from * along.x, x2 = segment.a.x + to * along.x;
        const std::int64_t first = column(std::min(x1, x2) - 1e-9),
                           last = column(std::max(x1, x2) + 1e-9);
        for (std::int64_t c = first; c <= last; ++c)
            visit(static_cast<std::size_t>(r * columns_ + c));
    }
}

double SegmentLattice::distance_of(std::size_t segment, Vec2 point) const {
    return segment_distance(segments_[segment].a, segments_[segment].b, point);
}

void SegmentLattice::look_in_cell(Vec2 point, std::int64_t column, std::int64_t row,
                                  Nearest& nearest) const {
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return;
    const auto at = static_cast<std::size_t>(row * columns_ + column);
    for (const std::uint32_t i : numbers_.in(at, at)) {
        const double away = distance_of(i, point);
        if (away < nearest.distance) nearest = {away, i};
    }
}

void SegmentLattice::look_in_ring(Vec2 point, std::int64_t ring, Nearest& nearest) const {
    const std::int64_t c = column(point.x), r = row(point.y);
    for (std::int64_t i = -ring; i <= ring; ++i) {
        const bool edge = i == -ring || i == ring;
        for (std::int64_t k = -ring; k <= ring; k += edge || ring == 0 ? 1 : 2 * ring)
            look_in_cell(point, c + k, r + i, nearest);
    }
}

SegmentLattice::Nearest SegmentLattice::nearest_to(Vec2 point) const {
    Nearest nearest{nowhere, 0};
    if (segments_.empty()) return nearest;
    // From a point outside the box everything is as far again as the box is.
    const Vec2 inside{std::clamp(point.x, box_.low.x, box_.high.x),
                      std::clamp(point.y, box_.low.y, box_.high.y)};
    const double outside = distance(point, inside);
    const std::int64_t rings = std::max(columns_, rows_);
    for (std::int64_t ring = 0; ring <= rings; ++ring) {
        look_in_ring(point, ring, nearest);
        if (nearest.distance <= static_cast<double>(ring) * cell_ - outside) break;
    }
    return nearest;
}

double SegmentLattice::distance_to(Vec2 point) const { return nearest_to(point).distance; }

// From segment to segment as long as the point comes nearer.
SegmentLattice::Nearest SegmentLattice::followed(Vec2 point, std::size_t segment) const {
    Nearest here{distance_of(segment, point), segment};
    for (const bool onwards : {true, false})
        while (onwards ? here.segment + 1 < segments_.size() : here.segment > 0) {
            const std::size_t next = onwards ? here.segment + 1 : here.segment - 1;
            const double away = distance_of(next, point);
            if (away >= here.distance) break;
            here = {away, next};
        }
    return here;
}

double SegmentLattice::farthest(const Polyline& places, double least) const {
    if (segments_.empty() && !places.empty()) return nowhere;
    std::size_t segment = 0;
    for (const Vec2 place : places) {
        Nearest nearest = followed(place, segment);
        if (nearest.distance > least) {
            nearest = nearest_to(place);
            least = std::max(least, nearest.distance);
        }
        segment = nearest.segment;
    }
    return least;
}

Polyline places_along(const Polyline& line, double step) {
    Polyline places;
    if (!line.empty()) places.push_back(line.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
        const int parts =
            std::max(1, static_cast<int>(std::ceil(distance(line[i - 1], line[i]) / step)));
        for (int k = 1; k <= parts; ++k)
            places.push_back(lerp(line[i - 1], line[i], static_cast<double>(k) / parts));
    }
    return places;
}

}  // namespace bead
