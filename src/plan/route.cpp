#include "plan/route.h"

namespace bead {
namespace {

double usual_speed(Role role, const Speeds& speeds) {
    switch (role) {
        case Role::travel:
            return speeds.travel;
        case Role::outer_wall:
            return speeds.outer_wall;
        case Role::skin:
            return speeds.skin;
        case Role::top_skin:
            return speeds.top_skin;
        case Role::infill:
            return speeds.infill;
        case Role::skirt:
            return speeds.skirt;
        case Role::wall:
        case Role::support:
        case Role::other:
            return speeds.wall;
    }
    return speeds.wall;
}

bool cross_each_other(Vec2 a, Vec2 b, Vec2 p, Vec2 q) {
    return (cross(b - a, p - a) > 0) != (cross(b - a, q - a) > 0) &&
           (cross(q - p, a - p) > 0) != (cross(q - p, b - p) > 0);
}

bool crosses(const Polyline& loop, Vec2 a, Vec2 b) {
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++)
        if (cross_each_other(a, b, loop[j], loop[i])) return true;
    return false;
}

}  // namespace

bool stays_inside(const Region& region, Vec2 a, Vec2 b) {
    for (const Polygon& polygon : region) {
        if (crosses(polygon.outer, a, b)) return false;
        for (const Polyline& hole : polygon.holes)
            if (crosses(hole, a, b)) return false;
    }
    return contains(region, a);
}

Route::Route(const LayerParts& layer, const PlanOptions& options, Vec2 start)
    : z_(layer.z), is_first_layer_(layer.index == 0), options_(options), at_(start) {}

double Route::speed_of(const Laid& as) const {
    const Speeds& speeds = options_.speeds;
    if (is_first_layer_) return speeds.first_layer;
    return as.on_infill && speeds.over_infill > 0 ? speeds.over_infill
                                                  : usual_speed(as.role, speeds);
}

double Route::acceleration_of(const Laid& as) const {
    if (is_first_layer_) return options_.first_layer_acceleration;
    return as.on_infill ? options_.over_infill_acceleration : 0;
}

void Route::lay(const Laid& as, const Polyline& line, const Region& around) {
    if (line.size() < 2) return;
    travel(line.front(), around);
    path_.push_back({as.role, as.bead, speed_of(as), acceleration_of(as), false, raised(line)});
    at_ = line.back();
}

void Route::travel(Vec2 to, const Region& around) {
    if (to == at_) return;
    const bool retracted =
        distance(at_, to) > options_.retract_before_travel && !stays_inside(around, at_, to);
    path_.push_back({Role::travel, {}, options_.speeds.travel, 0, retracted, raised({at_, to})});
    at_ = to;
}

std::vector<Vec3> Route::raised(const Polyline& line) const {
    std::vector<Vec3> points;
    points.reserve(line.size());
    for (const Vec2 p : line) points.push_back(at_height(p, z_));
    return points;
}

}  // namespace bead
