#include "study/reinforced_print.h"

#include <algorithm>

#include "geom/clip.h"
#include "geom/polygon.h"
#include "geom/short_order.h"
#include "geom/simplify.h"
#include "plan/route.h"
#include "study/crossing_flow.h"

namespace bead {
namespace {

constexpr double detail = 0.02;         // mm, by which a drawn line may differ from the laid one
constexpr double shortest_laid = 0.05;  // mm

Role role_of(LineKind kind) {
    if (kind == LineKind::wall) return Role::outer_wall;
    return kind == LineKind::pad ? Role::skin : Role::infill;
}

std::vector<LineKind> order(int layer, const PrintWish& print) {
    if (layer % 2 == 0 || print.crossing_flow < 1)
        return {LineKind::tensile, LineKind::compressive, LineKind::brace,
                LineKind::patch,   LineKind::pad,         LineKind::wall};
    return {LineKind::compressive, LineKind::tensile, LineKind::brace,
            LineKind::patch,       LineKind::pad,     LineKind::wall};
}

std::vector<Polyline> printed_lines(const LayeredLayout& print, LineKind kind) {
    std::vector<Polyline> lines;
    for (const Polyline& line : lines_of(print.layout, kind)) {
        Polyline simple = simplified(line, detail);
        for (Vec2& p : simple) p = p + print.shift;
        if (length(simple) >= shortest_laid) lines.push_back(std::move(simple));
    }
    return lines;
}

LayerParts frame_of(const LayeredLayout& print, int index) {
    LayerParts parts;
    parts.index = index;
    parts.height = print.load_case.print.layer_height;
    parts.z = (index + 1) * parts.height;
    parts.bead = printed_bead(print.load_case.print);
    return parts;
}

Region placed(const LayeredLayout& print) {
    return moved(print.load_case.part, 0, {}, print.shift);
}

std::vector<Polyline> skirt_of(const Region& part, const PlanOptions& options, const Bead& bead) {
    std::vector<Polyline> loops;
    for (int i = 0; i < options.skirt_loops; ++i)
        for (const Polygon& polygon :
             offset(part, options.skirt_gap + (i + 0.5) * spacing(bead), Corner::round)) {
            loops.push_back(simplified_loop(polygon.outer, detail));
            loops.back().push_back(loops.back().front());
        }
    return loops;
}

}  // namespace

std::vector<Toolpath> toolpaths(const LayeredLayout& print, const PlanOptions& options,
                                Vec2 start) {
    const Region part = placed(print);
    const PrintWish& wish = print.load_case.print;
    const std::vector<Polyline> tension = printed_lines(print, LineKind::tensile);
    std::vector<Toolpath> layers;
    Vec2 at = start;
    for (int index = 0; index < print.layers; ++index) {
        const LayerParts frame = frame_of(print, index);
        Route route(frame, options, at);
        if (index == 0)
            for (const Polyline& loop : skirt_of(part, options, frame.bead))
                route.lay({Role::skirt, frame.bead}, loop, {});
        for (const LineKind kind : order(index, wish)) {
            std::vector<Polyline> lines = printed_lines(print, kind);
            if (lines.empty()) continue;
            lines = short_order(std::move(lines), route.at());
            for (const std::vector<FlowPart>& line : flow_parts(lines, kind, tension, wish))
                for (const FlowPart& piece : line)
                    route.lay({role_of(kind), printed_bead(wish, piece.flow)}, piece.points, part);
        }
        at = route.at();
        layers.push_back(std::move(route).finished());
    }
    return layers;
}

void run(const LayeredLayout& print, const PlanOptions& options, const ProgramOptions& program,
         const CommandSink& sink) {
    std::vector<Command> commands;
    Nozzle nozzle;
    append_start(commands, nozzle, program);
    const std::vector<Toolpath> layers =
        toolpaths(print, options, {nozzle.at[axis_x], nozzle.at[axis_y]});
    for (int index = 0; index < print.layers; ++index) {
        const LayerParts frame = frame_of(print, index);
        append_layer(commands, layers[static_cast<std::size_t>(index)], frame.z, frame.height,
                     index, nozzle, program);
    }
    append_end(commands, nozzle, program);
    for (const Command& command : commands) sink(command);
}

}  // namespace bead
