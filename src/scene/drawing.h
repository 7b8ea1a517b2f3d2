// One layer's paths as a piece of SVG that keeps mm: what a panel of a picture holds.
#pragma once
#include <string>

#include "geom/box.h"
#include "toolpath/path.h"

namespace bead {

// A place on the page, px.
struct Frame {
    double left = 0, top = 0, width = 0, height = 0;
};

// Around the beads, mm; around the travel only if there is nothing else, for it may come from far
// away.
Box2 extent(const Toolpath& layer);

// The middle of the layer's extent comes to the middle of the frame; what does not fit is cut off.
// `scale`: px per mm.
std::string drawing(const Toolpath& layer, const Frame& frame, double scale);

// Whether there is something to draw of it.
bool is_drawn(const Path& path);

}  // namespace bead
