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
    constexpr double at_corners = 2.1;         // gaps: as far as a mitred corner may be
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
    constexpr double at_corners = 1.1;  // gaps, of the middle from either
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

// One wide bead in place of two paths, if the nozzle and the hot end can lay it.
std::optional<Path> merged(const Path& a, const Path& b, const Polyline& loop,
                           const BeadPlanOptions& options) {
    if (a.bead.height != b.bead.height || a.bead.height <= 0) return std::nullopt;
    const double together = (volume(a) + volume(b)) / loop_length(loop);
    Path path = along_loop(a, loop);
    path.bead.width = width_for(together, a.bead.height);
    constexpr double rounding = 1.02;  // the loop between two is not exactly their mean
    if (spacing(path.bead) > rounding * options.widest * options.nozzle) return std::nullopt;
    path.speed = std::min({a.speed, b.speed, options.max_flow / together});
    const double time_before = length(a) / a.speed + length(b) / b.speed;
    if (length(path) / path.speed > time_before) return std::nullopt;
    return path;
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
        std::optional<Path> wide = merged(first, second, *loop, options);
        if (!wide) continue;
        first = std::move(*wide);
        second.points.clear();
    }
}

}  // namespace

Toolpath bead_planned(const Toolpath& layer, const BeadPlanOptions& options) {
    Strokes strokes = strokes_of(layer);
    Loops loops = wall_loops(strokes);
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (loops[i].outer) merge_inner(strokes, loops, nest_of(loops, i, strokes), options);
    std::erase_if(strokes.strokes, [](const Stroke& stroke) { return stroke.path.points.empty(); });
    return joined(std::move(strokes));
}

}  // namespace bead
