#include "infill/edge_bands.h"

#include <numeric>

namespace bead {
namespace {

std::vector<Edge> edges_of(const std::vector<MeasuredLoop>& loops) {
    std::vector<Edge> edges;
    for (std::size_t loop = 0; loop < loops.size(); ++loop) {
        const Polyline& points = loops[loop].points;
        for (std::size_t i = 0; i < points.size(); ++i)
            edges.push_back({points[i], points[i + 1 < points.size() ? i + 1 : 0],
                             static_cast<int>(loop), loops[loop].at[i]});
    }
    return edges;
}

}  // namespace

EdgeBands::EdgeBands(const std::vector<MeasuredLoop>& loops) {
    constexpr std::size_t most_bands = 256;
    const std::vector<Edge> edges = edges_of(loops);
    for (const Edge& edge : edges) box_.include(edge.a);
    bands_ = std::clamp<std::size_t>(edges.size() / 2, 1, most_bands);
    const double height = box_.is_empty() ? 0 : box_.size().y;
    bands_per_mm_ = height > 0 ? static_cast<double>(bands_) / height : 0;

    const auto for_each_band = [&](const Edge& edge, const auto& visit) {
        const std::size_t last = band_of(std::max(edge.a.y, edge.b.y));
        for (std::size_t band = band_of(std::min(edge.a.y, edge.b.y)); band <= last; ++band)
            visit(band);
    };
    first_.assign(bands_ + 1, 0);
    for (const Edge& edge : edges) for_each_band(edge, [&](std::size_t b) { ++first_[b + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    edges_.resize(first_.back());
    std::vector<std::size_t> next = first_;
    for (const Edge& edge : edges)
        for_each_band(edge, [&](std::size_t b) { edges_[next[b]++] = edge; });
}

bool EdgeBands::contains(Vec2 point) const {
    if (point.y < box_.low.y || point.y > box_.high.y) return false;
    bool inside = false;
    for (const auto& [a, b, loop, at] : edges_in(band_of(point.y))) {
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

}  // namespace bead
