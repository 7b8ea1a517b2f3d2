#include "smooth/travel.h"

#include <algorithm>
#include <limits>

namespace bead {
namespace {

constexpr double stop_cost = 1.5;       // radii of travel that the two stops are worth
constexpr double sample_chord = 0.001;  // mm
constexpr double hair = 1e-6;           // mm

bool in_line(Vec2 a, Vec2 b) {
    constexpr double gentle = 0.98;  // cosine
    return dot(a, b) >= gentle * length(a) * length(b);
}

// As far as both ends are nearly in line there is nothing to stop for.
double straight_cost(const StrokeEnd& from, const StrokeEnd& to, double radius) {
    const Vec2 way = to.at - from.at;
    const double far = length(way);
    if (far < 1e-9) return in_line(from.along, to.along) ? 0 : stop_cost * radius;
    const bool smooth = in_line(from.along, way) && in_line(way, to.along);
    return far + (smooth ? 0 : stop_cost * radius);
}

// Over short ways wide turns would be most of them.
double turning_radius(const StrokeEnd& from, const StrokeEnd& to, double most) {
    return std::clamp(distance(from.at, to.at) / 2.5, most / 4, most);
}

double angle_of(Vec2 a) { return std::atan2(a.y, a.x); }

double turned_left(Vec2 from, Vec2 to) {
    const double angle = std::atan2(cross(from, to), dot(from, to));
    return angle < -1e-9 ? angle + 2 * pi : std::max(angle, 0.0);
}

// No more than turned_left of unit vectors, without an angle taken.
double least_turned_left(Vec2 from, Vec2 to) {
    constexpr double least = 1.37;  // of angle / (1 - cosine) up to half a turn
    const double ahead = dot(from, to);
    return cross(from, to) > -1e-8 ? least * (1 - ahead) : pi + least * (1 + ahead);
}

// Both circles on the sides `a` and `b` (1: left); as `dubins`, without the path itself.
double word_length(const StrokeEnd& from, const StrokeEnd& to, double radius, double a, double b,
                   double most) {
    const Vec2 way =
        (to.at + b * radius * left_of(to.along)) - (from.at + a * radius * left_of(from.along));
    const double apart = dot(way, way), across = a == b ? 0 : 2 * radius;
    const double rest = apart - across * across;
    if (rest < 0) return std::numeric_limits<double>::infinity();
    const double straight = std::sqrt(rest);
    if (straight >= most) return straight;
    Vec2 along = from.along;
    if (apart > 1e-18) along = rotated(way, Vec2{straight, a * across}) / apart;
    const Vec2 in0 = a > 0 ? from.along : along, in1 = a > 0 ? along : from.along;
    const Vec2 out0 = b > 0 ? along : to.along, out1 = b > 0 ? to.along : along;
    const double bound =
        straight + radius * (least_turned_left(in0, in1) + least_turned_left(out0, out1));
    if (bound >= most + hair) return bound;
    return straight + radius * (turned_left(in0, in1) + turned_left(out0, out1));
}

}  // namespace

double travel_cost(const StrokeEnd& from, const StrokeEnd& to, double widest) {
    const double radius = turning_radius(from, to, widest);
    double best = straight_cost(from, to, radius);
    for (const double a : {-1.0, 1.0})
        for (const double b : {-1.0, 1.0})
            best = std::min(best, word_length(from, to, radius, a, b, best));
    return best;
}

TravelLine travel_line(const StrokeEnd& from, const StrokeEnd& to, double widest) {
    const double radius = turning_radius(from, to, widest);
    const DubinsPath path =
        dubins({from.at, angle_of(from.along)}, {to.at, angle_of(to.along)}, radius);
    if (straight_cost(from, to, radius) < length(path)) return {{from.at, to.at}, true};
    Polyline points = flattened(path, sample_chord);
    points.back() = to.at;
    return {std::move(points), false};
}

}  // namespace bead
