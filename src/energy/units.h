// Joules in the units that the model counts in: newtons, millimetres, kilograms and seconds.
#pragma once

namespace bead {

inline constexpr double newton_mm = 1e-3;      // J
inline constexpr double kg_mm2_per_s2 = 1e-6;  // J

}  // namespace bead
