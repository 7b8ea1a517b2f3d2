#include "mesh/edges.h"

#include <algorithm>
#include <tuple>

#include "core/expects.h"

namespace bead {
namespace {

template <class Visit>
void for_each_side(const Mesh& mesh, Visit visit) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& corners = mesh.triangles[t];
        if (is_collapsed(corners)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = corners[k];
            const int to = corners[(k + 1) % 3];
            visit(Side{std::min(from, to), std::max(from, to), static_cast<int>(3 * t + k),
                       from < to});
        }
    }
}

}  // namespace

// A counting sort by the lower point leaves groups of about three sides, which are sorted one by
// one.
std::vector<Side> sorted_sides(const Mesh& mesh) {
    BEAD_EXPECTS(mesh.triangles.size() < std::numeric_limits<int>::max() / 3);
    std::vector<std::size_t> begin(mesh.points.size() + 1, 0);
    for_each_side(mesh, [&](const Side& side) { ++begin[static_cast<std::size_t>(side.low) + 1]; });
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];

    std::vector<Side> sides(begin.back());
    std::vector<std::size_t> next = begin;
    for_each_side(mesh, [&](const Side& s) { sides[next[static_cast<std::size_t>(s.low)]++] = s; });

    const auto order = [](const Side& a, const Side& b) {
        return std::tie(a.high, a.index) < std::tie(b.high, b.index);
    };
    for (std::size_t i = 0; i + 1 < begin.size(); ++i)
        std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin[i]),
                  sides.begin() + static_cast<std::ptrdiff_t>(begin[i + 1]), order);
    return sides;
}

}  // namespace bead
