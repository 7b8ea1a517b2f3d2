#include "geom/dubins.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/expects.h"

namespace bead {
namespace {

// Left 1, right -1.
struct Word {
    double first, last;
};
constexpr std::array words{Word{1, 1}, Word{-1, -1}, Word{1, -1}, Word{-1, 1}};

// The turn from one heading to another in one direction, 0 … 2π. Nearly a whole turn is rounding.
double turn(double from, double to, double side) {
    const double angle = side * (to - from);
    const double once = angle - 2 * pi * std::floor(angle / (2 * pi));
    return once > 2 * pi - 1e-9 ? 0 : side * once;
}

Vec2 centre_of(const Pose& pose, double side, double radius) {
    return pose.at + side * radius * left_of(unit(pose.heading));
}

// The straight line touches both circles; between circles of different sides it crosses from one
// to the other, and there is none when they overlap.
std::optional<DubinsPath> path_of(const Pose& from, const Pose& to, double radius, Word word) {
    const Vec2 way = centre_of(to, word.last, radius) - centre_of(from, word.first, radius);
    const double apart = length(way), across = word.first == word.last ? 0 : 2 * radius;
    if (apart < across) return std::nullopt;
    const double straight = std::sqrt(apart * apart - across * across);
    double heading = std::atan2(way.y, way.x) + word.first * std::atan2(across, straight);
    if (apart < 1e-9 * radius) heading = from.heading;  // one circle
    return DubinsPath{from, radius, turn(from.heading, heading, word.first), straight,
                      turn(heading, to.heading, word.last)};
}

Pose turned(const Pose& pose, double radius, double angle) {
    const double side = angle < 0 ? -1 : 1;
    const Vec2 centre = centre_of(pose, side, radius);
    return {centre + rotated(pose.at - centre, unit(angle)), pose.heading + angle};
}

}  // namespace

DubinsPath dubins(const Pose& from, const Pose& to, double radius) {
    BEAD_EXPECTS(radius > 0);
    std::optional<DubinsPath> best;
    for (const Word word : words) {
        const auto path = path_of(from, to, radius, word);
        if (path && (!best || length(*path) < length(*best))) best = path;
    }
    return *best;  // both ends turning the same way always works
}

double length(const DubinsPath& path) {
    return path.radius * (std::abs(path.first) + std::abs(path.last)) + path.straight;
}

Pose pose_at(const DubinsPath& path, double along) {
    const double arc = path.radius * std::abs(path.first);
    if (along < arc)
        return turned(path.start, path.radius, std::copysign(along / path.radius, path.first));
    Pose pose = turned(path.start, path.radius, path.first);
    pose.at = pose.at + std::min(along - arc, path.straight) * unit(pose.heading);
    const double rest = std::min(along, length(path)) - arc - path.straight;
    return rest > 0 ? turned(pose, path.radius, std::copysign(rest / path.radius, path.last))
                    : pose;
}

Polyline flattened(const DubinsPath& path, double tolerance) {
    BEAD_EXPECTS(tolerance > 0);
    const double step = 2 * std::acos(std::max(1 - tolerance / path.radius, 0.0));
    Polyline points{path.start.at};
    const auto turn_by = [&](double angle, double begin) {
        const int parts = static_cast<int>(std::ceil(std::abs(angle) / step));
        for (int i = 1; i <= parts; ++i) {
            const double part = static_cast<double>(i) / parts;
            points.push_back(pose_at(path, begin + part * path.radius * std::abs(angle)).at);
        }
    };
    turn_by(path.first, 0);
    const double arc = path.radius * std::abs(path.first);
    if (path.straight > 0) points.push_back(pose_at(path, arc + path.straight).at);
    turn_by(path.last, arc + path.straight);
    return points;
}

}  // namespace bead
