#include "study/green_part.h"

namespace bead {
namespace {

void scale(Polyline& line, double by) {
    for (Vec2& p : line) p = by * p;
}

}  // namespace

PrintWish as_sintered(const PrintWish& green, const SolidMaterial& material) {
    PrintWish sintered = green;
    sintered.bead_width /= material.green_plane;
    sintered.layer_height /= material.green_height;
    return sintered;
}

Toolpath as_sintered(Toolpath green, const SolidMaterial& material) {
    const double plane = 1 / material.green_plane, height = 1 / material.green_height;
    for (Path& path : green) {
        // The section shrinks both ways: as a rectangle, so that beads side by side stay so.
        const double wide = plane * spacing(path.bead), high = height * path.bead.height;
        path.bead = {wide + (1 - pi / 4) * high, high};
        for (Vec3& p : path.points) p = {plane * p.x, plane * p.y, height * p.z};
    }
    return green;
}

GreenPart green_part(Layout layout, LoadCase load_case) {
    const SolidMaterial& material = load_case.material;
    const double plane = material.green_plane;
    for (LayoutLine& line : layout) scale(line.points, plane);
    for (Polygon& polygon : load_case.part) {
        scale(polygon.outer, plane);
        for (Polyline& hole : polygon.holes) scale(hole, plane);
    }
    load_case.thickness *= material.green_height;
    load_case.print.bead_width *= plane;
    load_case.print.layer_height *= material.green_height;
    return {std::move(layout), std::move(load_case)};
}

}  // namespace bead
