#include "plan/plan.h"

namespace bead {
namespace {

double& part_for(Volumes& volumes, Role role) {
    switch (role) {
        case Role::outer_wall:
        case Role::wall:
            return volumes.wall;
        case Role::skin:
        case Role::top_skin:
            return volumes.skin;
        case Role::infill:
            return volumes.infill;
        case Role::support:
            return volumes.support;
        case Role::skirt:
            return volumes.skirt;
        case Role::travel:
        case Role::other:
            return volumes.other;
    }
    return volumes.other;
}

}  // namespace

Volumes asked_volumes(std::span<const LayerParts> parts, const PlanOptions& options) {
    Volumes asked;
    for (const LayerParts& layer : parts) {
        for (const Polyline& loop : layer.skirt)
            asked.skirt += loop_length(loop) * section(layer.bead);
        for (const Island& island : layer.islands) {
            for (const WallLoop& wall : island.walls)
                asked.wall += loop_length(wall.points) * section(layer.bead);
            for (const FillArea& area : island.fills)
                part_for(asked, area.role) += bead::area(area.material) * layer.height *
                                              (area.role == Role::infill ? options.density : 1);
        }
    }
    return asked;
}

Volumes deposited_volumes(const Toolpath& toolpath) {
    Volumes deposited;
    for (const Path& path : toolpath) part_for(deposited, path.role) += volume(path);
    return deposited;
}

Volumes operator+(const Volumes& a, const Volumes& b) {
    return {a.wall + b.wall,       a.skin + b.skin,   a.infill + b.infill,
            a.support + b.support, a.skirt + b.skirt, a.other + b.other};
}

}  // namespace bead
