// Travel of layers that do not say how fast it is.
#pragma once

namespace bead::cli {

inline constexpr double usual_travel_speed = 120;  // mm/s

}  // namespace bead::cli
