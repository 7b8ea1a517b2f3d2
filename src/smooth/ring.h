// Lines sampled densely, with what is deposited along each segment. A ring is closed and knows how
// far along each point lies; a ribbon is open and is what a stroke is made of.
#pragma once
#include <cstdint>

#include "smooth/lane.h"

namespace bead {

struct Ribbon {
    Polyline points;          // mm
    std::vector<Flow> flows;  // one less
};

struct Ring {
    Polyline points;                   // the first is not repeated
    std::vector<double> at;            // mm along, of every point
    std::vector<Flow> flows;           // of the segment after each point
    double length = 0;                 // mm
    Polyline marks;                    // at even distance, the first point first
    std::vector<std::uint32_t> hints;  // at even distance: a segment near there
};

struct RingSpot {
    Vec2 point, along;
};

Ring ring_of(Polyline points, std::vector<Flow> flows);
Ring reversed(const Ring& ring);

// Places are in mm along the ring, from any turn of it.
std::size_t segment_at(const Ring& ring, double place);
Vec2 point_at(const Ring& ring, double place);
RingSpot spot_at(const Ring& ring, double place);  // with the direction, a unit vector
Vec2 direction_at(const Ring& ring, double place);

// The place nearest to a point.
double nearest_place(const Ring& ring, Vec2 point);

// The ring from one place forward to another, at most a few turns on; both ends included.
void append_way(Ribbon& ribbon, const Ring& ring, double from, double to);
void append_point(Ribbon& ribbon, Vec2 point, const Flow& flow);

double length(const Ribbon& ribbon);
double volume(const Ribbon& ribbon);  // mm³

}  // namespace bead
