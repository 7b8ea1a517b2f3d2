// The shortest way from one place and direction to another for something that cannot turn more
// tightly than a radius: an arc, a straight line, an arc (L. Dubins 1957). Of the four words left
// or right, straight, left or right, the shortest is taken; three arcs, which only pay where the
// ends are nearer than four radii, are not.
//
//     const DubinsPath way = dubins({a, 0}, {b, pi / 2}, 2.5);
//     const Polyline travel = flattened(way, 0.02);
#pragma once
#include "geom/polygon.h"

namespace bead {

struct Pose {
    Vec2 at;
    double heading = 0;  // rad from +X
};

struct DubinsPath {
    Pose start;
    double radius = 1;    // mm
    double first = 0;     // rad, positive to the left
    double straight = 0;  // mm
    double last = 0;      // rad
};

DubinsPath dubins(const Pose& from, const Pose& to, double radius);  // radius above 0

double length(const DubinsPath& path);                         // mm
Pose pose_at(const DubinsPath& path, double along);            // mm from its start
Polyline flattened(const DubinsPath& path, double tolerance);  // chords stray at most that (mm)

}  // namespace bead
