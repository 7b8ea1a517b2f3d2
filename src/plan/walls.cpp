#include "plan/walls.h"

#include <algorithm>
#include <limits>

#include "geom/clip.h"
#include "plan/nearest_first.h"

namespace bead {
namespace {

constexpr double closest_sides = 0.6;       // of the spacing, between the two sides of a wall loop
constexpr double narrowest_material = 0.5;  // of the spacing

// The loops round one outline or hole, the outermost first.
struct Nest {
    std::vector<Polyline> loops;
    Region first;  // as a polygon
    Box2 box;
};

Region shrunk(const Region& region, double distance, double narrowest) {
    return offset(offset(region, -(distance + narrowest / 2)), narrowest / 2);
}

std::vector<Polyline> loops_of(Region region) {
    std::vector<Polyline> loops;
    for (Polygon& polygon : region) {
        loops.push_back(std::move(polygon.outer));
        for (Polyline& hole : polygon.holes) loops.push_back(std::move(hole));
    }
    return loops;
}

double distance_to(const Box2& box, Vec2 p) {
    return length(Vec2{std::max({box.low.x - p.x, p.x - box.high.x, 0.0}),
                       std::max({box.low.y - p.y, p.y - box.high.y, 0.0})});
}

Nest& nearest(std::vector<Nest>& nests, Vec2 point) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < nests.size(); ++i) {
        if (distance_to(nests[i].box, point) > least) continue;
        const double far = boundary_distance(nests[i].first, point);
        if (far >= least) continue;
        least = far;
        best = i;
    }
    return nests[best];
}

std::vector<Nest> nests_of(const Region& outline, const Bead& bead, int walls) {
    std::vector<Nest> nests;
    for (int i = 0; i < walls; ++i) {
        const double depth = bead.width / 2 + i * spacing(bead);
        for (Polyline& loop : loops_of(shrunk(outline, depth, closest_sides * spacing(bead)))) {
            Polyline line = from_seam(std::move(loop));
            if (i == 0)
                nests.push_back({{line}, {{line, {}}}, bounds(line)});
            else if (!nests.empty())
                nearest(nests, line.front()).loops.push_back(std::move(line));
        }
    }
    return nests;
}

double turn_at(const Polyline& loop, std::size_t i) {
    const std::size_t n = loop.size();
    const Vec2 in = loop[i] - loop[(i + n - 1) % n], out = loop[(i + 1) % n] - loop[i];
    return std::abs(std::atan2(cross(in, out), dot(in, out)));
}

// From the outer wall always on to the nearest of the nest's loops: backwards, that is the order to
// print them in.
void append_nest(std::vector<WallLoop>& loops, Nest nest) {
    Polyline outer = std::move(nest.loops.front());
    nest.loops.erase(nest.loops.begin());
    const auto seam = [](const Polyline& loop) { return loop.front(); };
    std::vector<Polyline> inner = nearest_first(std::move(nest.loops), outer.front(), seam);
    for (auto loop = inner.rbegin(); loop != inner.rend(); ++loop)
        loops.push_back({Role::wall, std::move(*loop)});
    loops.push_back({Role::outer_wall, std::move(outer)});
}

}  // namespace

Polyline from_seam(Polyline loop) {
    constexpr double as_sharp = 0.1;  // rad
    std::vector<double> turns(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) turns[i] = turn_at(loop, i);
    const double sharpest = *std::max_element(turns.begin(), turns.end());
    std::size_t seam = loop.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        if (turns[i] < sharpest - as_sharp) continue;
        if (seam == loop.size() || loop[i].y > loop[seam].y ||
            (loop[i].y == loop[seam].y && loop[i].x > loop[seam].x))
            seam = i;
    }
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(seam), loop.end());
    return loop;
}

Walled walled(const Polygon& outline, const Bead& bead, int walls) {
    const Region region{outline};
    const double narrowest = narrowest_material * spacing(bead);
    if (walls == 0) return {{}, opened(region, narrowest / 2)};
    Walled result;
    const double depth = bead.width / 2 + (walls - 0.5) * spacing(bead);
    result.material = shrunk(region, depth, narrowest);
    const auto seam = [](const Nest& nest) { return nest.loops.front().front(); };
    for (Nest& nest : nearest_first(nests_of(region, bead, walls), outline.outer.front(), seam))
        append_nest(result.loops, std::move(nest));
    return result;
}

}  // namespace bead
