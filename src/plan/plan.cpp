#include "plan/plan.h"

#include <algorithm>
#include <limits>

#include "geom/near_order.h"
#include "plan/fill_lines.h"
#include "plan/nearest_first.h"
#include "plan/route.h"

namespace bead {
namespace {

Polyline closed(const Polyline& loop) {
    Polyline line = loop;
    line.push_back(loop.front());
    return line;
}

Vec2 entry_of(const Island& island) {
    return island.walls.empty() ? island.outline.outer.front()
                                : island.walls.front().points.front();
}

FillLines lines_of(const FillArea& area, const LayerParts& layer, const FillChoice& choice,
                   const FillSpacing& lines, const PlanOptions& options) {
    if (area.patterned) return pattern_lines(area, choice, layer.centre);
    if (area.role != Role::infill) return solid_lines(area, choice.angle);
    const std::size_t i = index_of(choice.pattern);
    if (lines.by_pattern[i] > 0)
        return sparse_lines(area, layer, choice, lines.by_pattern[i], lines.flow[i]);
    return sparse_lines(area, layer, choice, spacing(layer.bead) / options.density, 1);
}

struct FilledArea {
    Role role;
    FillLines fill;
    bool on_infill;
};

double way_to(const FilledArea& area, Vec2 from) {
    double least = std::numeric_limits<double>::infinity();
    for (const Polyline& line : area.fill.lines)
        least = std::min({least, distance(from, line.front()), distance(from, line.back())});
    return least;
}

// Always on to the nearest area that is left; what is seen from above comes last.
void lay_fills(Route& route, std::vector<FilledArea> areas, const Region& around) {
    for (auto next = areas.begin(); next != areas.end(); ++next) {
        const auto nearest = std::min_element(next, areas.end(), [&](const auto& a, const auto& b) {
            const bool a_top = a.role == Role::top_skin, b_top = b.role == Role::top_skin;
            return a_top != b_top ? b_top : way_to(a, route.at()) < way_to(b, route.at());
        });
        std::iter_swap(next, nearest);
        for (const Polyline& line : near_order(std::move(next->fill.lines), route.at()))
            route.lay({next->role, next->fill.bead, next->on_infill}, line, around);
    }
}

}  // namespace

double layer_angle(double angle, int layer_index) {
    return layer_index % 2 == 0 ? angle : angle + pi / 2;
}

FillChoice usual_choice(const PlanOptions& options, int layer_index) {
    const double angle = layer_angle(options.angle, layer_index);
    return {options.pattern, angle, options.pattern.keeps_angle ? options.angle - angle : 0};
}

Toolpath plan_layer(const LayerParts& parts, const FillChoice& choice, const FillSpacing& lines,
                    const PlanOptions& options, Vec2 start) {
    Route route(parts, options, start);
    for (const Polyline& loop : parts.skirt) route.lay({Role::skirt, parts.bead}, closed(loop), {});
    std::vector<const Island*> islands;
    for (const Island& island : parts.islands) islands.push_back(&island);
    const auto entry = [](const Island* island) { return entry_of(*island); };
    for (const Island* island : nearest_first(std::move(islands), route.at(), entry)) {
        const Region around{island->outline};
        for (const WallLoop& wall : island->walls)
            route.lay({wall.role, parts.bead}, closed(wall.points), around);
        std::vector<FilledArea> areas;
        for (const FillArea& area : island->fills)
            areas.push_back(
                {area.role, lines_of(area, parts, choice, lines, options), area.on_infill});
        lay_fills(route, std::move(areas), around);
    }
    return std::move(route).finished();
}

Toolpath plan(std::span<const Layer> layers, const PlanOptions& options) {
    const std::vector<LayerParts> parts = parts_of(layers, options);
    const FillSpacing lines = matched_spacing(parts, options, {&options.pattern, 1});
    Toolpath whole;
    Vec2 at;
    for (const LayerParts& layer : parts) {
        const FillChoice choice = usual_choice(options, layer.index);
        for (Path& path : plan_layer(layer, choice, lines, options, at)) {
            at = flat(path.points.back());
            whole.push_back(std::move(path));
        }
    }
    return whole;
}

}  // namespace bead
