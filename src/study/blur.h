// Fields on pixels made smoother, or wider where they are high; what is outside the body counts as
// nothing, so that its edges do not fade.
#pragma once
#include <span>
#include <vector>

#include "fem/pixel_grid.h"

namespace bead {

// A Gaussian of the given standard deviation (mm), normalised by how much of it is solid.
std::vector<double> blurred(const std::vector<double>& values, std::span<const double> solid,
                            const PixelGrid& grid, double deviation);

// The highest value within a square of the given side (mm).
std::vector<double> widened(const std::vector<double>& values, const PixelGrid& grid, double side);

}  // namespace bead
