// Layers made by hand for the laws of smoothing: loops and lines of given roles, joined by travel.
#pragma once
#include <algorithm>

#include "geom/deviation.h"
#include "geom/polygon.h"
#include "toolpath/path.h"

namespace bead::test {

inline Polyline round_loop(Vec2 centre, double radius, int corners) {
    Polyline loop;
    for (int i = 0; i < corners; ++i) loop.push_back(centre + radius * unit(2 * pi * i / corners));
    return loop;
}

inline Polyline box_loop(Vec2 centre, double half_width, double half_height) {
    return {centre + Vec2{-half_width, -half_height}, centre + Vec2{half_width, -half_height},
            centre + Vec2{half_width, half_height}, centre + Vec2{-half_width, half_height}};
}

inline Path deposit(Role role, const Polyline& line, bool closed, double width = 0.4) {
    Path path;
    path.role = role;
    path.bead = {width, 0.2};
    path.speed = role == Role::infill ? 60 : 50;
    for (const Vec2 point : line) path.points.push_back(at_height(point, 0.2));
    if (closed) path.points.push_back(path.points.front());
    return path;
}

// With straight travel from one to the next, from the origin on.
inline Toolpath joined_by_travel(const std::vector<Path>& deposits) {
    Toolpath layer;
    Vec3 here{0, 0, 0.2};
    for (const Path& path : deposits) {
        Path travel;
        travel.speed = 120;
        travel.points = {here, path.points.front()};
        layer.push_back(std::move(travel));
        layer.push_back(path);
        here = path.points.back();
    }
    return layer;
}

inline double total_volume(const Toolpath& layer) {
    double sum = 0;
    for (const Path& path : layer) sum += volume(path);
    return sum;
}

inline Polyline line_of(const Path& path) {
    Polyline line;
    for (const Vec3& point : path.points) line.push_back(flat(point));
    return line;
}

inline Polyline points_of(const Toolpath& layer, Role role) {
    Polyline points;
    for (const Path& path : layer)
        if (path.role == role)
            for (const Vec3& point : path.points) points.push_back(flat(point));
    return points;
}

// Largest distance from places along `line` to the nearest path of that role.
inline double farthest(const Polyline& line, const Toolpath& layer, Role role) {
    double most = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        for (const double t : {0.0, 0.25, 0.5, 0.75}) {
            double least = 1e9;
            for (const Path& path : layer)
                if (path.role == role)
                    least = std::min(least,
                                     line_distance(line_of(path), lerp(line[i], line[i + 1], t)));
            most = std::max(most, least);
        }
    return most;
}

}  // namespace bead::test
