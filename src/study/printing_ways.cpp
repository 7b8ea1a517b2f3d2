#include "study/printing_ways.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "geom/clip.h"
#include "geom/curve_recovery.h"
#include "smooth/bead_plan.h"
#include "smooth/chord_error.h"
#include "smooth/coverage.h"
#include "smooth/metrics.h"
#include "smooth/strokes.h"

namespace bead {
namespace {

std::vector<Polyline> lines_of(const Toolpath& layer, Role role) {
    std::vector<Polyline> lines;
    for (const Path& path : layer) {
        if (path.role != role) continue;
        Polyline& line = lines.emplace_back();
        for (const Vec3& p : path.points) line.push_back(flat(p));
    }
    return lines;
}

SmoothOptions retessellating(SmoothOptions options) {
    options.stages = {.clean = true,
                      .curves = true,
                      .chains = false,
                      .order = false,
                      .blends = false,
                      .chords = true};
    return options;
}

Polyline with_curves(const Polyline& loop) {
    constexpr double chord_tolerance = 0.0006;  // mm
    Polyline points;
    for (const RecoveredRun& run : recovered_loop(loop, {})) {
        const Polyline piece = run.curve ? flattened(*run.curve, chord_tolerance) : run.points;
        points.insert(points.end(), piece.begin(), piece.end() - 1);
    }
    return points;
}

// From the lowest, then leftmost corner.
void begin_at_lowest(Path& path) {
    if (!is_loop(path)) return;
    Polyline loop = loop_of(path);
    const auto lowest = std::min_element(loop.begin(), loop.end(), [](Vec2 a, Vec2 b) {
        return std::pair(a.y, a.x) < std::pair(b.y, b.x);
    });
    std::rotate(loop.begin(), lowest, loop.end());
    loop.push_back(loop.front());
    for (std::size_t i = 0; i < loop.size(); ++i)
        path.points[i] = at_height(loop[i], path.points[i].z);
}

}  // namespace

Region with_curves(const Region& section) {
    std::vector<Polyline> loops;
    const auto add = [&](const Polyline& loop) { loops.push_back(with_curves(loop)); };
    for (const Polygon& polygon : section) {
        add(polygon.outer);
        std::ranges::for_each(polygon.holes, add);
    }
    return region_of(loops, FillRule::positive);
}

Toolpath naive_section(const Region& section, const SectionOptions& options) {
    Strokes strokes = strokes_of(sliced_section(section, options));
    // Loop after loop from the outside in, row by row: what does not look where it is.
    const auto place = [](const Stroke& stroke) {
        Box2 box;
        for (const Vec3& p : stroke.path.points) box.include(flat(p));
        return std::tuple(stroke.path.role, -box.size().x, box.low.y, box.low.x);
    };
    for (Stroke& stroke : strokes.strokes) begin_at_lowest(stroke.path);
    std::ranges::stable_sort(strokes.strokes, {}, place);
    return joined(std::move(strokes));
}

std::vector<Figure> path_figures(const Toolpath& layer, const Toolpath& plain,
                                 const Region& section, double band) {
    const PathMetrics m = path_metrics(layer);
    const Coverage c = wall_coverage(layer, with_curves(section), band);
    const std::vector<Polyline> outer = lines_of(plain, Role::outer_wall);
    return {{"length, mm", m.length},
            {"extruded, mm", m.extruded},
            {"travel, mm", m.travel},
            {"infill with travel, mm", m.infill_length},
            {"infill alone, mm", m.lengths[static_cast<std::size_t>(Role::infill)]},
            {"points", static_cast<double>(m.points)},
            {"infill points", static_cast<double>(m.infill_points)},
            {"turns 30°", static_cast<double>(m.turning_points_30)},
            {"turns 45°", static_cast<double>(m.turning_points)},
            {"turns 60°", static_cast<double>(m.turning_points_60)},
            {"windowed turns", static_cast<double>(m.windowed_turning_points)},
            {"e_c (Eq. 31), mm", m.chord_error_mean},
            {"outer wall off B1's, mm",
             outer.empty() ? 0 : chord_error(layer, Role::outer_wall, outer)},
            {"shortest segment, mm", m.shortest_segment},
            {"travels across walls", static_cast<double>(m.travels_crossing_walls)},
            {underfill_name, c.underfill},
            {overfill_name, c.overfill},
            {"outside, mm²", c.outside},
            {"outline off by, mm", c.outline_deviation}};
}

std::vector<ShakenPath> printing_ways(const std::string& part, const Region& section,
                                      const WaysOptions& options) {
    const Toolpath plain = sliced_section(section, options.section);
    SmoothOptions smooth = options.smooth, wide = smooth;
    wide.stages.bead_plan = true;
    SmoothOptions thin = wide;
    thin.stages.thinning = true;
    if (!plain.empty()) smooth.start = wide.start = thin.start = flat(plain.front().points.front());
    std::vector<ShakenPath> ways;
    const auto add = [&](const char* name, Toolpath layer) {
        const double band = options.section.walls * spacing(options.section.bead);
        std::vector<Figure> figures = path_figures(layer, plain, section, band);
        ways.push_back({name, part, std::move(layer), std::move(figures)});
    };
    add("B1", plain);
    add("B1r", smoothed(plain, retessellating(smooth)).path);
    add("B1w", greedily_ordered(bead_planned(plain)));
    add("T1", smoothed(plain, smooth).path);
    add("T2", smoothed(plain, wide).path);
    add("T2t", smoothed(plain, thin).path);
    return ways;
}

}  // namespace bead
