#include "smooth/sliced_section.h"

#include <algorithm>

#include "geom/clip.h"
#include "smooth/strokes.h"

namespace bead {
namespace {

void add_loops(Strokes& strokes, const Region& region, const Path& like, double least_area) {
    for (const Polygon& polygon : region) {
        std::vector<Polyline> loops{polygon.outer};
        loops.insert(loops.end(), polygon.holes.begin(), polygon.holes.end());
        for (const Polyline& loop : loops) {
            if (std::abs(signed_area(loop)) < least_area) continue;
            Path path = like;
            for (const Vec2 p : loop) path.points.push_back(at_height(p, like.bead.height));
            path.points.push_back(path.points.front());
            strokes.strokes.push_back({std::move(path), {}});
        }
    }
}

struct Place {
    double away;
    std::size_t corner;
};

// Of a loop the nearest corner, of an open line the nearer end.
Place nearest_start(const Path& path, Vec3 from) {
    Place best{distance(flat(path.points[0]), flat(from)), 0};
    const std::size_t step = is_loop(path) ? 1 : path.points.size() - 1;
    for (std::size_t i = 0; i < path.points.size(); i += std::max<std::size_t>(1, step)) {
        const double away = distance(flat(path.points[i]), flat(from));
        if (away < best.away) best = {away, i};
    }
    return best;
}

Path begun_at(Path path, std::size_t corner) {
    if (!is_loop(path)) {
        if (corner > 0) std::ranges::reverse(path.points);
        return path;
    }
    path.points.pop_back();
    const auto start = path.points.begin() + static_cast<std::ptrdiff_t>(corner);
    std::rotate(path.points.begin(), start, path.points.end());
    path.points.push_back(path.points.front());
    return path;
}

// The nearest of those from `first` to `last` comes to `first`; returns where it ends.
Vec3 bring_nearest(std::vector<Stroke>& strokes, std::size_t first, std::size_t last, Vec3 from) {
    std::size_t nearest = first;
    Place best = nearest_start(strokes[first].path, from);
    for (std::size_t i = first + 1; i < last; ++i) {
        const Place place = nearest_start(strokes[i].path, from);
        if (place.away >= best.away) continue;
        best = place;
        nearest = i;
    }
    std::swap(strokes[first], strokes[nearest]);
    strokes[first].path = begun_at(std::move(strokes[first].path), best.corner);
    return strokes[first].path.points.back();
}

Toolpath ordered(Strokes strokes) {
    std::vector<Stroke>& all = strokes.strokes;
    const auto is_wall = [](const Stroke& stroke) {
        return stroke.path.role == Role::outer_wall || stroke.path.role == Role::wall;
    };
    const auto middle = std::stable_partition(all.begin(), all.end(), is_wall);
    const auto walls = static_cast<std::size_t>(middle - all.begin());
    Vec3 here = strokes.start;
    for (std::size_t i = 0; i < all.size(); ++i)
        here = bring_nearest(all, i, i < walls ? walls : all.size(), here);
    return joined(std::move(strokes));
}

}  // namespace

Toolpath sliced_section(const Region& section, const SectionOptions& options) {
    Strokes strokes;
    const Vec2 corner = bounds(section).low - Vec2{5, 5};
    strokes.start = at_height(corner, options.bead.height);
    strokes.leaving.speed = options.travel_speed;
    Path like;
    like.role = Role::outer_wall;
    like.bead = options.bead;
    like.speed = options.wall_speed;
    for (int k = 0; k < options.walls; ++k) {
        add_loops(strokes, offset(section, -(k + 0.5) * spacing(options.bead)), like, 0);
        like.role = Role::wall;
    }
    like.role = Role::infill;
    like.speed = options.infill_speed;
    const double band = options.walls * spacing(options.bead);
    for (double in = options.infill_spacing / 2;; in += options.infill_spacing) {
        const Region inner = offset(section, -(band + in));
        if (inner.empty()) break;
        add_loops(strokes, inner, like, options.least_infill);
    }
    return ordered(std::move(strokes));
}

Toolpath greedily_ordered(const Toolpath& layer) { return ordered(strokes_of(layer)); }

}  // namespace bead
