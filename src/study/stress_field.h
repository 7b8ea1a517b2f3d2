// The stress of the solid part under a case's loads, as a field of tensors on a square grid that
// covers it: what stress lines are traced in. Solved on pixels (Q4); nodes beyond the boundary take
// the mean of those beside them, so that a place near it finds values all around.
#pragma once
#include "fem/load_case.h"
#include "field/sampled.h"
#include "field/tensor.h"

namespace bead {

// MPa. `cell`: mm, side of a pixel. Of the situation's loads as they are, without their ranges.
Sampled<PlaneTensor> solid_stress(const LoadCase& load_case, std::size_t situation, double cell);

}  // namespace bead
