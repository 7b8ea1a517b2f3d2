#include "study/green_part.h"

#include "study/similar_case.h"

namespace bead {

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
        path.bead = bead_of(wide * high, high);
        for (Vec3& p : path.points) p = {plane * p.x, plane * p.y, height * p.z};
    }
    return green;
}

GreenPart green_part(Layout layout, const LoadCase& load_case) {
    const SolidMaterial& material = load_case.material;
    LoadCase larger = similar(load_case, material.green_plane);
    larger.thickness = load_case.thickness * material.green_height;
    larger.print.layer_height = load_case.print.layer_height * material.green_height;
    return {similar(std::move(layout), material.green_plane), std::move(larger)};
}

}  // namespace bead
