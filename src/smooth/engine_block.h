// A section of W16, the stand-in for the engine block of the published experiment, which is not to
// be had: 194 mm square, 16 bores of 34 mm, 25 bolt holes of 8 mm, and, depending on the height,
// slots for coolant or oil. Round holes are polygons as an STL has them: 75 and 24 corners.
//
//     const Region section = engine_block(75);   // at 75 % of the height: bores and bolts only
#pragma once
#include <array>

#include "geom/polygon.h"

namespace bead {

inline constexpr std::array<int, 4> engine_block_heights{15, 25, 50, 75};  // %

// One of the four heights.
Region engine_block(int height_percent);

}  // namespace bead
