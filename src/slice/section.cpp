#include "slice/section.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/expects.h"

namespace bead {
namespace {

struct Ends {
    int from = 0, to = 0;  // points
};

Ends ends_of(const Mesh& mesh, int side) {
    const auto& corners = mesh.triangles[static_cast<std::size_t>(side / 3)];
    const auto k = static_cast<std::size_t>(side % 3);
    return {corners[k], corners[(k + 1) % 3]};
}

}  // namespace

std::vector<int> opposite_sides(const Mesh& mesh, std::span<const Side> sides) {
    std::vector<int> opposite(3 * mesh.triangles.size(), -1);
    for_each_edge(sides, [&](std::span<const Side> edge) {
        const auto next = [&](std::size_t from, bool rising) {
            while (from < edge.size() && edge[from].rising != rising) ++from;
            return from;
        };
        std::size_t up = next(0, true);
        std::size_t down = next(0, false);
        while (up < edge.size() && down < edge.size()) {
            opposite[static_cast<std::size_t>(edge[up].index)] = edge[down].index;
            opposite[static_cast<std::size_t>(edge[down].index)] = edge[up].index;
            up = next(up + 1, true);
            down = next(down + 1, false);
        }
    });
    return opposite;
}

// How the cut goes through a triangle: in through the side that runs down through the plane, out
// through the one that runs up. Then the triangle's outside is on the right.
struct Cutter::Pass {
    int in = -1, out = -1;
};

Cutter::Cutter(const Mesh& mesh, std::span<const int> opposite)
    : mesh_(mesh), opposite_(opposite), seen_(mesh.triangles.size(), 0) {
    BEAD_EXPECTS(opposite.size() == 3 * mesh.triangles.size());
}

Cutter::Pass Cutter::pass(int triangle, double plane) const {
    const auto& corners = mesh_.triangles[static_cast<std::size_t>(triangle)];
    std::array<bool, 3> above{};
    for (std::size_t k = 0; k < 3; ++k)
        above[k] = mesh_.points[static_cast<std::size_t>(corners[k])].z >= plane;
    Pass pass;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (above[k] && !above[next]) pass.in = 3 * triangle + static_cast<int>(k);
        if (!above[k] && above[next]) pass.out = 3 * triangle + static_cast<int>(k);
    }
    BEAD_EXPECTS(pass.in >= 0 && pass.out >= 0);
    return pass;
}

// From the lower point's view whichever way the side runs: both triangles get the same bits.
Vec2 Cutter::crossing(int side, double plane) const {
    const Ends ends = ends_of(mesh_, side);
    const Vec3 a = mesh_.points[static_cast<std::size_t>(std::min(ends.from, ends.to))];
    const Vec3 b = mesh_.points[static_cast<std::size_t>(std::max(ends.from, ends.to))];
    return lerp(flat(a), flat(b), (plane - a.z) / (b.z - a.z));
}

int Cutter::beyond(int side) const {
    const int other = opposite_[static_cast<std::size_t>(side)];
    return other < 0 ? -1 : other / 3;
}

// Appends a point per triangle from `seed` on. True if the walk came back to the seed.
bool Cutter::walk_on(int seed, double plane, Polyline& line) {
    int triangle = seed;
    while (true) {
        seen_[static_cast<std::size_t>(triangle)] = cut_;
        const Pass way = pass(triangle, plane);
        line.push_back(crossing(way.in, plane));
        triangle = beyond(way.out);
        if (triangle == seed) return true;
        if (triangle >= 0) continue;
        line.push_back(crossing(way.out, plane));
        return false;
    }
}

// Appends the points before `seed`, nearest first, up to the open edge where the line begins.
void Cutter::walk_back(int seed, double plane, Polyline& line) {
    int triangle = beyond(pass(seed, plane).in);
    while (triangle >= 0) {
        seen_[static_cast<std::size_t>(triangle)] = cut_;
        const Pass way = pass(triangle, plane);
        line.push_back(crossing(way.in, plane));
        triangle = beyond(way.in);
    }
}

Section Cutter::at(double plane, std::span<const int> crossed) {
    ++cut_;
    Section section;
    for (const int seed : crossed) {
        if (seen_[static_cast<std::size_t>(seed)] == cut_) continue;
        Polyline line;
        if (walk_on(seed, plane, line)) {
            section.loops.push_back(std::move(line));
            continue;
        }
        Polyline before;
        walk_back(seed, plane, before);
        std::ranges::reverse(before);
        before.insert(before.end(), line.begin(), line.end());
        section.open.push_back(std::move(before));
    }
    return section;
}

}  // namespace bead
