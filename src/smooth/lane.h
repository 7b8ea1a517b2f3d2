// What a layer deposits, as lines: consecutive paths of one role that meet are one lane, and a lane
// that ends within a bead's width of where it began is a loop; slicers leave a gap at the seam.
#pragma once
#include "geom/polygon.h"
#include "toolpath/path.h"

namespace bead {

struct Flow {
    double section = 0;  // mm²
    double speed = 0;    // mm/s
    Role role = Role::other;
    int ramp = 0;       // above 0: on the way from one section to another, at that step of it
    double height = 0;  // mm, of the bead
    bool operator==(const Flow&) const = default;
};

// Whether one chord may lie over both.
bool alike(const Flow& a, const Flow& b);

struct Lane {
    Role role = Role::other;
    double height = 0, z = 0;  // mm
    double acceleration = 0;   // mm/s², 0: the printer's usual
    bool closed = false;       // the first point is not repeated
    bool level = true;         // all of it at one z; nothing is done to lanes that are not
    Polyline points;           // mm
    std::vector<Flow> flows;   // of the segments, the closing one included
    double volume = 0;         // mm³ as given, without what closing the gap would add
    std::size_t first_path = 0, paths = 0;  // of the layer
};

// In printing order. Lanes of fewer than two different points are left out.
std::vector<Lane> lanes_of(const Toolpath& layer);

// Without points nearer than `shortest` to the one before or nearer than `straight` to the line
// between those that stay, as far as the flow on both sides is the same (mm).
Lane cleaned(Lane lane, double shortest = 0.02, double straight = 0.005);

// The width of a bead of this height and cross-section.
double width_of(double section, double height);
// Of the bead that the lane begins with.
double width_of(const Lane& lane);

}  // namespace bead
