// The vertices that carry the phase of stripes.h: corners of those square cells that the region
// touches, joined by edges, and cut into two triangles per cell.
#pragma once
#include <array>
#include <vector>

#include "geom/polygon.h"
#include "infill/line_field.h"

namespace bead {

struct StripeGrid {
    std::vector<Vec2> places;
    std::vector<Vec2> normals;                  // across the lines, unit vectors of free sign
    std::vector<double> waves;                  // rad/mm, 2 π / spacing
    std::vector<std::array<int, 2>> edges;      // along the sides of cells
    std::vector<std::array<int, 3>> triangles;  // counter-clockwise
};

StripeGrid stripe_grid(const Region& region, const LineField& field, double cell);

// What the phase of one vertex should become on the way to another.
struct PhaseStep {
    bool flips = false;  // the two count the phase in opposite directions
    double growth = 0;   // rad, in the first one's direction
};
PhaseStep phase_step(const StripeGrid& grid, int from, int to);

}  // namespace bead
