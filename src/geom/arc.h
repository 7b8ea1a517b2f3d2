// Arcs of circles, and the circle through three points.
#pragma once
#include "geom/polygon.h"

namespace bead {

// Not one of a machine: that is Arc in toolpath/command.h.
struct PlanarArc {
    Vec2 centre;
    double radius = 1;  // mm
    double start = 0;   // rad, direction from the centre to the first point
    double sweep = 0;   // rad, positive counter-clockwise
};

inline double length(const PlanarArc& arc) { return arc.radius * std::abs(arc.sweep); }
inline Vec2 point_at(const PlanarArc& arc, double part) {  // 0 … 1
    return arc.centre + arc.radius * unit(arc.start + part * arc.sweep);
}

// Of the circle through three points: infinity when they lie on a line.
double circumradius(Vec2 a, Vec2 b, Vec2 c);

// How far an arc of this radius rises above a chord of this length, r - √(r² - chord²/4); 0 for an
// infinite radius. Chords longer than the diameter count as the diameter.
double sagitta(double radius, double chord);

// Mean over all inner points of the sagitta of the first chord of each triple of points, as papers
// on toolpaths print it. It is large at a corner between long lines though nothing is wrong there,
// and falls when points are put on a straight line: `deviation` (geom/deviation.h) is the honest
// one.
double mean_chord_sagitta(const Polyline& line);

}  // namespace bead
