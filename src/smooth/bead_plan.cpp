#include "smooth/bead_plan.h"

#include <algorithm>
#include <optional>

#include "geom/clip.h"
#include "geom/deviation.h"
#include "smooth/strokes.h"

namespace bead {
namespace {

struct WallLoop {
    std::size_t stroke;
    Polyline points;
    Box2 box;
    double area, length;  // mm² without sign, mm
    bool outer;
    bool taken = false;  // belongs to a nest already
};

using Loops = std::vector<WallLoop>;

bool is_wall(const Path& path) { return path.role == Role::outer_wall || path.role == Role::wall; }

Loops wall_loops(const Strokes& strokes) {
    Loops loops;
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i) {
        const Path& path = strokes.strokes[i].path;
        if (!is_wall(path) || !is_loop(path)) continue;
        Polyline points = loop_of(path);
        const Box2 box = bounds(points);
        const double size = std::abs(signed_area(points)), around = loop_length(points);
        const bool outer = path.role == Role::outer_wall;
        loops.push_back({i, std::move(points), box, size, around, outer});
    }
    return loops;
}

Polyline closed(Polyline loop) {
    loop.push_back(loop.front());
    return loop;
}

// The distance between two loops if they run side by side all the way round, about a bead apart.
std::optional<double> gap_between(const WallLoop& a, const WallLoop& b, double width) {
    constexpr double least = 0.6, most = 1.3;  // bead widths
    constexpr double at_corners = 6;           // gaps: as far as the tip of a sharp corner may be
    const double gap = 2 * std::abs(a.area - b.area) / (a.length + b.length);
    if (gap < least * width || gap > most * width) return std::nullopt;
    const auto apart = [&](double p, double q) { return std::abs(p - q) > at_corners * gap; };
    if (apart(a.box.low.x, b.box.low.x) || apart(a.box.low.y, b.box.low.y) ||
        apart(a.box.high.x, b.box.high.x) || apart(a.box.high.y, b.box.high.y))
        return std::nullopt;
    const double step = std::max(a.length, b.length);  // corners only
    if (deviation(a.points, closed(b.points), step) > at_corners * gap ||
        deviation(b.points, closed(a.points), step) > at_corners * gap)
        return std::nullopt;
    return gap;
}

std::optional<std::size_t> next_inwards(const Loops& loops, std::size_t from, double width) {
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (!loops[i].outer && !loops[i].taken && gap_between(loops[from], loops[i], width))
            return i;
    return std::nullopt;
}

// Half-way from `a` to `b`; nothing if that is not one loop beside both.
std::optional<Polyline> between(const WallLoop& a, const WallLoop& b, double gap) {
    constexpr double at_corners = 3;  // gaps, of the middle from either
    Polyline points = a.points;
    const bool reversed = signed_area(points) < 0;
    if (reversed) std::ranges::reverse(points);
    const Region middle = offset({{points, {}}}, (b.area < a.area ? -gap : gap) / 2);
    if (middle.size() != 1 || !middle[0].holes.empty()) return std::nullopt;
    Polyline loop = middle[0].outer;
    const double step = a.length + b.length;
    if (deviation(loop, closed(a.points), step) > at_corners * gap ||
        deviation(loop, closed(b.points), step) > at_corners * gap)
        return std::nullopt;
    if (reversed) std::ranges::reverse(loop);
    return loop;
}

// Wide beads along these loops in place of the paths, of which the first lie beside the loops, if
// the nozzle and the hot end can lay them.
std::optional<std::vector<Path>> merged(const std::vector<const Path*>& paths,
                                        const std::vector<Polyline>& loops,
                                        const BeadPlanOptions& options) {
    double deposited = 0, along = 0, time_before = 0, time = 0;
    for (const Path* path : paths) {
        if (path->bead.height != paths[0]->bead.height || path->bead.height <= 0)
            return std::nullopt;
        deposited += volume(*path);
        time_before += length(*path) / path->speed;
    }
    for (const Polyline& loop : loops) along += loop_length(loop);
    const double together = deposited / along;
    std::vector<Path> wide;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        Path path = along_loop(*paths[i], loops[i]);
        path.bead.width = width_for(together, path.bead.height);
        path.speed = std::min(path.speed, options.max_flow / together);
        time += length(path) / path.speed;
        wide.push_back(std::move(path));
    }
    constexpr double rounding = 1.02;  // the loop between two is not exactly their mean
    const bool fits = spacing(wide[0].bead) <= rounding * options.widest * options.nozzle;
    if (!fits || time > time_before) return std::nullopt;
    return wide;
}

// Loops from an outer wall inwards, as far as each has one neighbour that runs along all of it.
std::vector<std::size_t> nest_of(Loops& loops, std::size_t outer, const Strokes& strokes) {
    std::vector<std::size_t> nest{outer};
    loops[outer].taken = true;
    const auto width = [&](std::size_t loop) {
        return strokes.strokes[loops[loop].stroke].path.bead.width;
    };
    while (const auto next = next_inwards(loops, nest.back(), width(nest.back()))) {
        loops[*next].taken = true;
        nest.push_back(*next);
    }
    return nest;
}

// Which strokes are replaced: those with no points are gone.
void merge_inner(Strokes& strokes, const Loops& loops, const std::vector<std::size_t>& nest,
                 const BeadPlanOptions& options) {
    for (std::size_t k = 1; k + 1 < nest.size(); k += 2) {
        const WallLoop &a = loops[nest[k]], &b = loops[nest[k + 1]];
        Path &first = strokes.strokes[a.stroke].path, &second = strokes.strokes[b.stroke].path;
        const std::optional<double> gap = gap_between(a, b, first.bead.width);
        if (!gap) continue;
        const std::optional<Polyline> loop = between(a, b, *gap);
        if (!loop) continue;
        std::optional<std::vector<Path>> wide = merged({&first, &second}, {*loop}, options);
        if (!wide) continue;
        first = std::move((*wide)[0]);
        second.points.clear();
    }
}

// A second loop whose third one has grown together with those of its neighbours.
struct Unpaired {
    std::size_t loop;
    double gap;     // mm, from the outer wall
    Polyline wide;  // half a gap farther from the outer wall
};

std::optional<Unpaired> unpaired(const Loops& loops, std::size_t outer, std::size_t loop,
                                 double width) {
    const WallLoop& a = loops[loop];
    const std::optional<double> gap = gap_between(loops[outer], a, width);
    if (!gap) return std::nullopt;
    const bool grows = a.area > loops[outer].area;
    Polyline points = a.points;
    const bool reversed = signed_area(points) < 0;
    if (reversed) std::ranges::reverse(points);
    const Region moved = offset({{points, {}}}, (grows ? *gap : -*gap) / 2);
    if (moved.size() != 1 || !moved[0].holes.empty()) return std::nullopt;
    Polyline wide = moved[0].outer;
    if (reversed) std::ranges::reverse(wide);
    return Unpaired{loop, *gap, std::move(wide)};
}

bool is_beside(const WallLoop& a, const Polyline& b, double reach) {
    return std::ranges::any_of(a.points, [&](Vec2 p) { return line_distance(b, p) <= reach; });
}

// All of the third loop lies about a gap from one of them, and nothing between them overlaps much.
bool is_shared(const WallLoop& third, const std::vector<const Unpaired*>& seconds,
               const Loops& loops) {
    constexpr double at_corners = 2.1, apart = 0.2;  // gaps, mm
    for (const Vec2 p : third.points)
        if (std::ranges::none_of(seconds, [&](const Unpaired* second) {
                return line_distance(closed(loops[second->loop].points), p) <=
                       at_corners * second->gap;
            }))
            return false;
    for (const Unpaired* a : seconds)
        for (const Unpaired* b : seconds)
            if (a != b && std::ranges::any_of(a->wide, [&](Vec2 p) {
                    return line_distance(closed(b->wide), p) < apart;
                }))
                return false;
    return true;
}

// A third loop that runs round several seconds: its volume goes to all of them.
void merge_shared(Strokes& strokes, const WallLoop& third, std::vector<Unpaired>& open,
                  const Loops& loops, const BeadPlanOptions& options) {
    const Polyline line = closed(third.points);
    std::vector<const Unpaired*> seconds;
    std::vector<const Path*> paths;
    std::vector<Polyline> wide;
    for (const Unpaired& second : open) {
        if (!is_beside(loops[second.loop], line, 1.3 * second.gap)) continue;
        seconds.push_back(&second);
        paths.push_back(&strokes.strokes[loops[second.loop].stroke].path);
        wide.push_back(second.wide);
    }
    if (seconds.empty() || !is_shared(third, seconds, loops)) return;
    paths.push_back(&strokes.strokes[third.stroke].path);
    std::optional<std::vector<Path>> beads = merged(paths, wide, options);
    if (!beads) return;
    strokes.strokes[third.stroke].path.points.clear();
    std::vector<std::size_t> done;
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        done.push_back(seconds[i]->loop);
        strokes.strokes[loops[done.back()].stroke].path = std::move((*beads)[i]);
    }
    std::erase_if(open, [&](const Unpaired& second) {
        return std::ranges::find(done, second.loop) != done.end();
    });
}

}  // namespace

Toolpath bead_planned(const Toolpath& layer, const BeadPlanOptions& options) {
    Strokes strokes = strokes_of(layer);
    Loops loops = wall_loops(strokes);
    std::vector<Unpaired> open;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (!loops[i].outer) continue;
        const std::vector<std::size_t> nest = nest_of(loops, i, strokes);
        merge_inner(strokes, loops, nest, options);
        if (nest.size() != 2) continue;
        const double width = strokes.strokes[loops[i].stroke].path.bead.width;
        if (auto second = unpaired(loops, i, nest[1], width)) open.push_back(*std::move(second));
    }
    for (const WallLoop& third : loops)
        if (!third.outer && !third.taken) merge_shared(strokes, third, open, loops, options);
    std::erase_if(strokes.strokes, [](const Stroke& stroke) { return stroke.path.points.empty(); });
    return joined(std::move(strokes));
}

}  // namespace bead
