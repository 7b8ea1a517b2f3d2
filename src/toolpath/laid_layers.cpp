#include "toolpath/laid_layers.h"

#include <algorithm>
#include <cmath>

namespace bead {
namespace {

constexpr double same_height = 1e-4;   // mm
constexpr double same_section = 0.03;  // relative, within which moves go on with a path
constexpr double chord = 0.2;          // mm, of an arc
constexpr double least_way = 1e-6;     // mm

}  // namespace

LaidLayers::LaidLayers(double filament_diameter, double height)
    : filament_area_(pi / 4 * filament_diameter * filament_diameter), height_(height) {}

void LaidLayers::add(const Command& command) {
    if (const auto* move = std::get_if<Move>(&command.what)) follow(*move);
    if (const auto* arc = std::get_if<Arc>(&command.what)) follow(*arc);
    if (const auto* set = std::get_if<SetPosition>(&command.what))
        for (std::size_t axis = 0; axis < axis_count; ++axis)
            at_[axis] = set->to[axis].value_or(at_[axis]);
    if (const auto* home = std::get_if<Home>(&command.what))
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (home->axes[axis]) at_[axis] = 0;
    if (const auto* start = std::get_if<LayerStart>(&command.what)) {
        said_z_ = start->z;
        said_height_ = start->height;
    }
}

void LaidLayers::follow(const Move& move) {
    const Vec2 from{at_[axis_x], at_[axis_y]}, to{move.to[axis_x], move.to[axis_y]};
    const double extruded = move.to[axis_e] - at_[axis_e], way = distance(from, to);
    at_ = move.to;
    if (extruded > 0 && way > least_way) lay(move, extruded * filament_area_ / way, from);
}

void LaidLayers::follow(const Arc& arc) {
    const Vec2 centre{arc.centre[0], arc.centre[1]};
    const Vec2 from = Vec2{at_[axis_x], at_[axis_y]} - centre;
    const Vec2 to = Vec2{arc.end.to[axis_x], arc.end.to[axis_y]} - centre;
    if (arc.plane != Plane::xy || length(from) < least_way) return follow(arc.end);
    double turn = std::atan2(cross(from, to), dot(from, to));
    if (arc.clockwise && turn >= 0) turn -= 2 * pi;
    if (!arc.clockwise && turn <= 0) turn += 2 * pi;
    turn += (arc.clockwise ? -2 : 2) * pi * arc.more_turns;
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::abs(turn) * length(from) / chord)));
    const Position start = at_;
    for (int i = 1; i <= count; ++i) {
        Move piece = arc.end;
        const double part = static_cast<double>(i) / count;
        if (i < count) {
            const Vec2 p = centre + rotated(from, unit(part * turn));
            piece.to = {p.x, p.y, start[axis_z] + part * (arc.end.to[axis_z] - start[axis_z]),
                        start[axis_e] + part * (arc.end.to[axis_e] - start[axis_e])};
        }
        follow(piece);
    }
}

LaidLayer& LaidLayers::layer_at(double z) {
    if (!layers_.empty() && std::abs(layers_.back().z - z) < same_height) return layers_.back();
    const double below = layers_.empty() ? 0 : layers_.back().z;
    const bool is_said = std::abs(said_z_ - z) < same_height && said_height_ > 0;
    const double step = z - below > same_height ? z - below : height_;
    layers_.push_back({z, is_said ? said_height_ : std::min(step, 2 * height_), {}});
    return layers_.back();
}

void LaidLayers::lay(const Move& move, double section, Vec2 from) {
    LaidLayer& layer = layer_at(at_[axis_z]);
    const Bead bead = bead_of(section, layer.height);
    const Vec3 start = at_height(from, layer.z);
    const Vec3 end = at_height({at_[axis_x], at_[axis_y]}, layer.z);
    if (!layer.paths.empty()) {
        Path& last = layer.paths.back();
        const double known = bead::section(last.bead);
        if (last.role == move.role && length(last.points.back() - start) < least_way &&
            std::abs(known - section) <= same_section * known) {
            last.points.push_back(end);
            return;
        }
    }
    Path path;
    path.role = move.role;
    path.bead = bead;
    path.speed = move.feed;
    path.points = {start, end};
    layer.paths.push_back(std::move(path));
}

std::vector<LaidLayer> LaidLayers::finished() && { return std::move(layers_); }

}  // namespace bead
