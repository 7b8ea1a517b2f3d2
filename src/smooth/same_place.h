// How near two points of a layer are one: less than G-code says, more than rounding makes of it.
// it.
#pragma once

namespace bead {

inline constexpr double same_place = 1e-6;  // mm

}  // namespace bead
