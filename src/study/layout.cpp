#include "study/layout.h"

#include "study/crossing_flow.h"

namespace bead {
namespace {

constexpr std::array roles{Role::outer_wall, Role::skin,   Role::infill,
                           Role::infill,     Role::infill, Role::infill};

}  // namespace

double deposited_area(const Layout& layout, double bead_width) {
    double sum = 0;
    for (const LayoutLine& line : layout) sum += length(line.points);
    return sum * bead_width;
}

double deposited_area(const Layout& layout, double bead_width, LineKind kind) {
    double sum = 0;
    for (const LayoutLine& line : layout)
        if (line.kind == kind) sum += length(line.points);
    return sum * bead_width;
}

double deposited_area(const Layout& layout, const PrintWish& print, LineKind kind) {
    if (print.crossing_flow >= 1) return deposited_area(layout, print.bead_width, kind);
    double sum = 0;
    for (const std::vector<FlowPart>& line :
         flow_parts(lines_of(layout, kind), kind, lines_of(layout, LineKind::tensile), print))
        for (const FlowPart& part : line) sum += part.flow * length(part.points);
    return sum * print.bead_width;
}

double deposited_area(const Layout& layout, const PrintWish& print) {
    return deposited_area(layout, print.bead_width) -
           deposited_area(layout, print.bead_width, LineKind::compressive) +
           deposited_area(layout, print, LineKind::compressive);
}

std::vector<Polyline> lines_of(const Layout& layout, LineKind kind) {
    std::vector<Polyline> lines;
    for (const LayoutLine& line : layout)
        if (line.kind == kind) lines.push_back(line.points);
    return lines;
}

Bead printed_bead(const PrintWish& print, double flow) {
    return bead_of(flow * print.bead_width * print.layer_height, print.layer_height);
}

Toolpath layer_of(const Layout& layout, const PrintWish& print) {
    Toolpath layer;
    const std::vector<Polyline> tension = lines_of(layout, LineKind::tensile);
    const auto lay = [&](const FlowPart& part, Role role) {
        Path path;
        path.role = role;
        path.bead = printed_bead(print, part.flow);
        for (const Vec2 p : part.points) path.points.push_back(at_height(p, 0));
        layer.push_back(std::move(path));
    };
    for (const LayoutLine& line : layout)
        for (const auto& parts : flow_parts({line.points}, line.kind, tension, print))
            for (const FlowPart& part : parts)
                lay(part, roles[static_cast<std::size_t>(line.kind)]);
    return layer;
}

}  // namespace bead
