// The edges of a region in horizontal bands: which are near a piece of curve, is a point inside?
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "geom/along.h"

namespace bead {

struct Edge {
    Vec2 a, b;
    int loop = 0;
    double at = 0;  // mm along the loop, of a
};

class EdgeBands {
  public:
    explicit EdgeBands(const std::vector<MeasuredLoop>& loops);

    [[nodiscard]] bool contains(Vec2 point) const;  // even-odd

    // Calls visit(edge) for every edge that may touch the box; for some more than once.
    template <class Visit>
    void for_each_near(Vec2 low, Vec2 high, const Visit& visit) const {
        if (high.y < box_.low.y || low.y > box_.high.y || high.x < box_.low.x ||
            low.x > box_.high.x)
            return;
        const std::size_t last = band_of(high.y);
        for (std::size_t band = band_of(low.y); band <= last; ++band)
            for (const Edge& edge : edges_in(band))
                if (std::max(edge.a.x, edge.b.x) >= low.x && std::min(edge.a.x, edge.b.x) <= high.x)
                    visit(edge);
    }

  private:
    [[nodiscard]] std::size_t band_of(double y) const {
        const double band = (y - box_.low.y) * bands_per_mm_;
        return static_cast<std::size_t>(std::clamp(band, 0.0, static_cast<double>(bands_ - 1)));
    }
    [[nodiscard]] std::span<const Edge> edges_in(std::size_t band) const {
        return std::span(edges_).subspan(first_[band], first_[band + 1] - first_[band]);
    }

    Box2 box_;
    std::size_t bands_ = 1;
    double bands_per_mm_ = 0;
    std::vector<Edge> edges_;         // band by band
    std::vector<std::size_t> first_;  // of every band, and the end
};

}  // namespace bead
