#include "smooth/smooth.h"

namespace bead {

SmoothedLayer smoothed(const Toolpath& layer, const SmoothOptions& /*options*/) {
    return {.path = layer};
}

}  // namespace bead
