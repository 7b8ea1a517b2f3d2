#include "smooth/layer_line.h"

#include "smooth/same_place.h"

namespace bead {
namespace {

void append(LayerLine& line, Vec2 point, Role role) {
    if (!line.points.empty()) {
        if (distance(line.points.back(), point) <= same_place) return;
        line.roles.push_back(role);
    }
    line.points.push_back(point);
}

}  // namespace

LayerLine line_of(const Toolpath& layer) {
    LayerLine line;
    for (const Path& path : layer)
        for (std::size_t i = 0; i < path.points.size(); ++i)
            append(line, flat(path.points[i]), i == 0 ? Role::travel : path.role);
    line.phases = line.roles;
    Role next = Role::travel;
    for (std::size_t i = line.phases.size(); i-- > 0;) {
        if (line.phases[i] == Role::travel)
            line.phases[i] = next;
        else
            next = line.phases[i];
    }
    return line;
}

Polyline without_short_segments(const Polyline& line, double least) {
    Polyline rest;
    for (const Vec2 p : line)
        if (rest.empty() || distance(rest.back(), p) >= least) rest.push_back(p);
    return rest;
}

}  // namespace bead
