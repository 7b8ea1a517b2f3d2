// The nouns of the plane: open lines, closed polygons with holes, regions of several polygons.
// A closed loop does not repeat its first point. Lengths in mm, areas in mm².
#pragma once
#include <span>
#include <vector>

#include "geom/box.h"
#include "geom/vec.h"

namespace bead {

using Polyline = std::vector<Vec2>;

struct Polygon {
    Polyline outer;               // counter-clockwise
    std::vector<Polyline> holes;  // clockwise
    bool operator==(const Polygon&) const = default;
};

using Region = std::vector<Polygon>;  // pairwise disjoint

double length(std::span<const Vec2> line);       // of an open line
double loop_length(std::span<const Vec2> loop);  // closing edge included
double perimeter(const Region& region);          // of all outlines and holes

double signed_area(std::span<const Vec2> loop);  // positive when counter-clockwise
double area(const Polygon& polygon);
double area(const Region& region);

Box2 bounds(std::span<const Vec2> points);
Box2 bounds(const Region& region);

// Even-odd rule, O(points). Points on the boundary may fall on either side.
bool contains(const Region& region, Vec2 point);

// Distance from the point to the nearest outline or hole; infinity for an empty region.
double boundary_distance(const Region& region, Vec2 point);

// Turned by `angle` (rad, counter-clockwise) about `about`, then moved by `shift`.
Polyline moved(Polyline line, double angle, Vec2 about, Vec2 shift);
Region moved(Region region, double angle, Vec2 about, Vec2 shift);

}  // namespace bead
