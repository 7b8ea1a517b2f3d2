#include "study/layout.h"

#include "geom/polygon.h"

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

Bead printed_bead(const PrintWish& print) {
    return {print.bead_width + (1 - pi / 4) * print.layer_height, print.layer_height};
}

Toolpath layer_of(const Layout& layout, const PrintWish& print) {
    Toolpath layer;
    for (const LayoutLine& line : layout) {
        Path path;
        path.role = roles[static_cast<std::size_t>(line.kind)];
        path.bead = printed_bead(print);
        for (const Vec2 p : line.points) path.points.push_back(at_height(p, 0));
        layer.push_back(std::move(path));
    }
    return layer;
}

}  // namespace bead
