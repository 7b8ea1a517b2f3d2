// Where a coordinate is in whole motor steps, rounded as 8-bit firmware does it: the coordinate
// becomes a 32-bit float, the product with steps/mm is one too, halves go away from zero. With
// three decimals and 100 steps/mm ties are common, so the width of the float decides.
#pragma once
#include <cmath>
#include <cstdint>

namespace bead {

inline std::int64_t steps_at(double mm, double steps_per_mm) {
    const float product = static_cast<float>(mm) * static_cast<float>(steps_per_mm);
    return std::llround(product);
}

}  // namespace bead
