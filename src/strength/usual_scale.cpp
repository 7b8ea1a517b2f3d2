#include "strength/usual_scale.h"

#include <algorithm>

namespace bead {

double usual_scale(const PrintWish& print) {
    constexpr double finest = 0.4, widest = 0.9;  // mm
    return std::clamp(print.bead_width, finest, widest) / print.bead_width;
}

}  // namespace bead
