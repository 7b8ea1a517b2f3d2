#include "layers_of_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "gcode/reader.h"
#include "geom/box.h"
#include "study/green_part.h"
#include "toolpath/laid_layers.h"

namespace bead::cli {
namespace {

bool belongs_to_part(const Path& path) {
    return path.role != Role::skirt && path.role != Role::support && path.role != Role::travel;
}

Box2 box_of(const std::vector<Toolpath>& layers) {
    Box2 box;
    for (const Toolpath& layer : layers)
        for (const Path& path : layer) {
            const double half = spacing(path.bead) / 2;
            for (const Vec3& p : path.points) {
                box.include(flat(p) - Vec2{half, half});
                box.include(flat(p) + Vec2{half, half});
            }
        }
    return box;
}

void expect_same_size(const std::string& file, const Box2& laid, const Box2& part, double width) {
    const Vec2 off = laid.size() - part.size();
    if (std::abs(off.x) <= width && std::abs(off.y) <= width) return;
    throw Error(
        fmt::format("{}: what it prints is {:.1f} x {:.1f} mm, the case's part {:.1f} x "
                    "{:.1f} mm; it must be the same part, not turned",
                    file, laid.size().x, laid.size().y, part.size().x, part.size().y));
}

}  // namespace

std::vector<Toolpath> layers_of_file(const std::string& file, const LoadCase& load_case,
                                     double filament) {
    LaidLayers laid(filament, load_case.print.layer_height * load_case.material.green_height);
    read_gcode(std::filesystem::path(file), [&](const Command& command) { laid.add(command); });
    std::vector<Toolpath> layers;
    for (LaidLayer& layer : std::move(laid).finished()) {
        std::erase_if(layer.paths, [](const Path& path) { return !belongs_to_part(path); });
        if (!layer.paths.empty())
            layers.push_back(as_sintered(std::move(layer.paths), load_case.material));
    }
    if (layers.empty()) throw Error(file + ": lays no bead of a part; is it a print?");
    const Box2 box = box_of(layers), part = bounds(load_case.part);
    expect_same_size(file, box, part, load_case.print.bead_width);
    const Vec2 shift = part.centre() - box.centre();
    for (Toolpath& layer : layers)
        for (Path& path : layer)
            for (Vec3& p : path.points) p = p + at_height(shift, 0);
    return layers;
}

}  // namespace bead::cli
