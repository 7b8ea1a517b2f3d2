// How near to failing a printed body is, place by place: the largest principal stress over what the
// material bears in tension, or the smallest over what it bears in compression. At a notch between
// two beads this grows without end as pixels shrink; a material fails over a length of its own. So
// the index (the scalar: means of the tensor would hide bending) is averaged over the solid within
// a radius, and what lies close to loads and supports, which in reality are pads and pins, is left
// out.
#pragma once
#include <vector>

#include "fem/load_case.h"
#include "fem/pixel_model.h"
#include "field/tensor.h"

namespace bead {

// 1: fails. Of a state of stress of an isotropic material.
inline double failure_index(PlaneTensor stress, const SolidMaterial& material) {
    const Principal p = principal(stress);
    return std::max(p.first / material.tensile, -p.second / material.compressive);
}

// How the index changes with stress: its change is that of the components times these, the shear
// counted twice.
inline PlaneTensor failure_slope(PlaneTensor stress, const SolidMaterial& material) {
    const Principal p = principal(stress);
    const bool pulls = p.first / material.tensile >= -p.second / material.compressive;
    const Vec2 n = unit(pulls ? p.angle : p.angle + pi / 2);
    const double by = pulls ? 1 / material.tensile : -1 / material.compressive;
    return by * PlaneTensor{n.x * n.x, n.y * n.y, n.x * n.y};
}

// Each solid pixel's mean over the solid pixels whose middles lie within `radius` (mm).
std::vector<double> averaged_over_solid(const PixelModel& model, const std::vector<double>& values,
                                        double radius);

// The adjoint of that: what a weighted sum of the means weighs each value by.
std::vector<double> averaging_adjoint(const PixelModel& model, const std::vector<double>& weights,
                                      double radius);

// Per pixel: whether its middle lies farther than `distance` (mm) from all of the lines.
std::vector<std::uint8_t> far_from(const PixelGrid& grid, const std::vector<Polyline>& lines,
                                   double distance);

}  // namespace bead
