// Stress from displacement on pixels, as tensors: at pixel centres, where Q4 stress is best, or at
// nodes as the mean of what the solid pixels around extrapolate to them.
#pragma once
#include <span>
#include <vector>

#include "fem/pixel_model.h"
#include "field/tensor.h"

namespace bead {

// Per pixel; zero where there is none.
std::vector<PlaneTensor> centre_stress(const PixelModel& model,
                                       std::span<const double> displacement);
// The adjoint of that: nodal forces f so that f·u is the sum over pixels of stress times `weight`,
// component by component, the shear counted twice.
PixelVector centre_stress_adjoint(const PixelModel& model, std::span<const PlaneTensor> weight);
// Per node; zero where there is no solid pixel around. Each pixel's bilinear stress is taken at the
// node, then the mean over the pixels.
std::vector<PlaneTensor> node_stress(const PixelModel& model, std::span<const double> displacement);

// Twice the strain energy of a pixel, N mm, whether of the displacement or of a buckling mode.
std::vector<double> pixel_energy(const PixelModel& model, std::span<const double> displacement);

}  // namespace bead
