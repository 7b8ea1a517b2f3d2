#include "geom/delaunay.h"

#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>

#include "geom/polygon.h"

namespace bead {
namespace {

using WholePoint = boost::polygon::point_data<std::int32_t>;

std::vector<WholePoint> rounded(std::span<const Vec2> points) {
    const Box2 box = bounds(points);
    const double extent = std::max({box.size().x, box.size().y, 1e-300});
    const double scale = double(1 << 30) / extent;
    std::vector<WholePoint> whole;
    whole.reserve(points.size());
    for (const Vec2 p : points)
        whole.emplace_back(std::int32_t(std::lround((p.x - box.low.x) * scale)),
                           std::int32_t(std::lround((p.y - box.low.y) * scale)));
    return whole;
}

}  // namespace

std::vector<std::array<int, 3>> delaunay(std::span<const Vec2> points) {
    std::vector<std::array<int, 3>> triangles;
    if (points.size() < 3) return triangles;
    const std::vector<WholePoint> whole = rounded(points);
    boost::polygon::voronoi_diagram<double> diagram;
    boost::polygon::construct_voronoi(whole.begin(), whole.end(), &diagram);
    for (const auto& vertex : diagram.vertices()) {
        std::vector<int> around;
        const auto* edge = vertex.incident_edge();
        do {
            around.push_back(int(edge->cell()->source_index()));
            edge = edge->rot_next();
        } while (edge != vertex.incident_edge());
        for (std::size_t k = 1; k + 1 < around.size(); ++k) {
            std::array<int, 3> t{around[0], around[k], around[k + 1]};
            const Vec2 a = points[std::size_t(t[0])];
            if (cross(points[std::size_t(t[1])] - a, points[std::size_t(t[2])] - a) < 0)
                std::swap(t[1], t[2]);
            triangles.push_back(t);
        }
    }
    return triangles;
}

}  // namespace bead
