#include "slice/crossing.h"

#include <algorithm>

#include "mesh/edges.h"

namespace bead {

std::vector<PlaneRange> crossed_planes(const Mesh& mesh, std::span<const double> planes) {
    const auto planes_up_to = [&](double z) {
        return static_cast<int>(std::ranges::upper_bound(planes, z) - planes.begin());
    };
    std::vector<PlaneRange> ranges;
    ranges.reserve(mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        const auto z = [&](std::size_t k) {
            return mesh.points[static_cast<std::size_t>(triangle[k])].z;
        };
        const auto [low, high] = std::minmax({z(0), z(1), z(2)});
        ranges.push_back(is_collapsed(triangle)
                             ? PlaneRange{}
                             : PlaneRange{planes_up_to(low), planes_up_to(high)});
    }
    return ranges;
}

CrossedTriangles::CrossedTriangles(std::span<const PlaneRange> ranges, int first, int end)
    : first_(first), begin_(static_cast<std::size_t>(end - first) + 1, 0) {
    const auto for_each_crossing = [&](auto visit) {
        for (std::size_t t = 0; t < ranges.size(); ++t)
            for (int p = std::max(ranges[t].first, first); p < std::min(ranges[t].end, end); ++p)
                visit(static_cast<std::size_t>(p - first), static_cast<int>(t));
    };
    for_each_crossing([&](std::size_t plane, int) { ++begin_[plane + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    triangles_.resize(begin_.back());
    std::vector<std::size_t> next = begin_;
    for_each_crossing([&](std::size_t plane, int t) { triangles_[next[plane]++] = t; });
}

std::span<const int> CrossedTriangles::of(int plane) const {
    const auto i = static_cast<std::size_t>(plane - first_);
    return std::span(triangles_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
}

}  // namespace bead
