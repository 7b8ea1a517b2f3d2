// A layer taken apart into what is deposited, each stroke with the travel that led to it, and put
// together again after strokes were changed, dropped or put in another order. Travel that no longer
// fits its ends becomes a straight line.
#pragma once
#include "geom/polygon.h"
#include "toolpath/path.h"

namespace bead {

struct Stroke {
    Path path;    // deposits something
    Path travel;  // what led to it; no points: it began where the one before ended
};

struct Strokes {
    std::vector<Stroke> strokes;
    Path leaving;  // travel after the last stroke
    Vec3 start;    // where the layer's first path begins
};

Strokes strokes_of(const Toolpath& layer);

// Of an untouched layer: the same toolpath, empty paths left out.
Toolpath joined(Strokes strokes);

// A loop goes round once and ends where it began.
bool is_loop(const Path& path);
Polyline loop_of(const Path& path);  // the first point is not repeated

// As `like`, but along this loop, from its corner nearest to where `like` began, z as there.
Path along_loop(const Path& like, const Polyline& loop);

// The width of a bead of this height whose cross-section is `section` mm².
double width_for(double section, double height);

}  // namespace bead
