#include "layer_outline.h"

#include <algorithm>
#include <cmath>

#include "geom/clip.h"
#include "outline_curves.h"
#include "smooth/chord_error.h"
#include "smooth/coverage.h"

namespace bead::cli {
namespace {

constexpr double seam_gap = 1;  // mm, between a loop's ends as slicers leave it
constexpr double joint = 0.002;

// Outer walls that go on in several paths (of other speeds) are one line.
std::vector<Polyline> outer_loops(const Toolpath& layer) {
    std::vector<Polyline> lines;
    for (const Path& path : layer) {
        if (path.role != Role::outer_wall) continue;
        const Vec2 first = flat(path.points.front());
        const bool goes_on = !lines.empty() && distance(lines.back().back(), first) < joint;
        if (!goes_on) lines.push_back({first});
        for (std::size_t i = 1; i < path.points.size(); ++i)
            lines.back().push_back(flat(path.points[i]));
    }
    std::erase_if(lines, [](const Polyline& line) {
        return line.size() < 4 || distance(line.front(), line.back()) > seam_gap;
    });
    for (Polyline& line : lines)
        if (distance(line.front(), line.back()) < joint) line.pop_back();
    return lines;
}

// Thin parts have outer walls that are no loops.
Region outer_beads(const Toolpath& layer) {
    std::vector<WideLine> beads;
    for (const Path& path : layer) {
        if (path.role != Role::outer_wall) continue;
        Polyline line;
        for (const Vec3& point : path.points) line.push_back(flat(point));
        beads.push_back({std::move(line), spacing(path.bead)});
    }
    return covered_by(beads, Corner::round);
}

struct Walls {
    double outer = 0, all = 0, spacing = 0;  // mm
};
Walls walls_of(const Toolpath& layer) {
    Walls walls;
    for (const Path& path : layer) {
        if (path.role != Role::outer_wall && path.role != Role::wall) continue;
        const double way = length(path);
        walls.all += way;
        if (path.role != Role::outer_wall) continue;
        walls.outer += way;
        walls.spacing = spacing(path.bead);
    }
    return walls;
}

}  // namespace

void add_coverage(const LayerPair& layer, PathFigures& before, PathFigures& after) {
    const std::vector<Polyline> loops = outer_loops(layer.before);
    if (loops.empty()) return;
    const Walls walls = walls_of(layer.before);
    const Region outline = united(offset(region_of(loops, FillRule::even_odd), walls.spacing / 2),
                                  outer_beads(layer.before));
    const double band =
        walls.spacing * std::max(1.0, std::round(walls.all / std::max(walls.outer, 1e-9)));
    const std::vector<Polyline> curves = outline_curves(loops);
    const auto add = [&](const Toolpath& path, PathFigures& figures) {
        const Coverage coverage = wall_coverage(path, outline, band);
        figures.underfill += coverage.underfill;
        figures.overfill += coverage.overfill;
        figures.outline_deviation = std::max(figures.outline_deviation, coverage.outline_deviation);
        figures.true_chord_error =
            std::max(figures.true_chord_error, chord_error(path, Role::outer_wall, curves));
    };
    add(layer.before, before);
    add(layer.after, after);
}

}  // namespace bead::cli
