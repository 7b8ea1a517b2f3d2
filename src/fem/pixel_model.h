// An elastic sheet on a grid of pixels (Q4 squares with exact integrals): what is solid, how stiff
// each pixel is, and which nodes are held. The immersed model of everything that is printed.
// Unknowns are numbered 2 * node (x) and 2 * node + 1 (y) over all nodes of the grid; those of
// nodes that touch no solid pixel stay 0.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "fem/pixel_grid.h"
#include "fem/plane_law.h"
#include "geom/polygon.h"

namespace bead {

struct PixelModel {
    PixelGrid grid;
    double thickness = 1;        // mm
    std::vector<double> factor;  // per pixel; 0: absent, not weak
    PlaneLaw law;                // times the factor
    std::vector<PlaneLaw> laws;  // per pixel in its place, if there are any
};

// Per unknown: held at 0 or free.
using Held = std::vector<std::uint8_t>;
// Per unknown: N, or mm.
using PixelVector = std::vector<double>;

inline PlaneLaw law_of(const PixelModel& model, std::size_t pixel) {
    return model.factor[pixel] * (model.laws.empty() ? model.law : model.laws[pixel]);
}

// Solid (1) where the pixel's centre lies inside, else 0.
std::vector<double> rastered(const Region& region, const PixelGrid& grid);
// The share of the pixel that lies inside, on a 4 x 4 pattern of points.
std::vector<double> coverage(const Region& region, const PixelGrid& grid);

// What hangs together through pixel sides with a pixel near one of the places (within `reach`, mm);
// pieces that do not are made absent. A corner is no joint: it would be a hinge.
std::vector<double> connected(const std::vector<double>& factor, const PixelGrid& grid,
                              std::span<const Vec2> places, double reach);

// K u, element by element. Held unknowns are treated like any other.
PixelVector forces(const PixelModel& model, std::span<const double> displacement);

}  // namespace bead
