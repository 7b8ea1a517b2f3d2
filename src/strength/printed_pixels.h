// What a layer of beads covers: a pixel is solid if its middle lies within half a bead's width of a
// bead's centre line. Beads that touch merge, as printed ones do. A bead counts as the rectangle of
// its layer's height that has its cross-section, so that beads side by side fill the plane and
// weigh what they cover.
#pragma once
#include <vector>

#include "fem/pixel_grid.h"
#include "toolpath/path.h"

namespace bead {

// Per pixel: 1 where there is plastic, else 0. Travel is left out.
std::vector<double> printed_pixels(const Toolpath& layer, const PixelGrid& grid);

// mm, of the layer's beads; 0 if it has none.
double height_of(const Toolpath& layer);

// How the plastic lies in a pixel: along the nearest bead, and whether beads cross there.
struct BeadDirection {
    float angle = 0;          // rad, of the nearest bead
    float off = 1e9F;         // mm, from its centre line; 1e9: no bead
    bool is_crossed = false;  // by a bead in another direction, 20° or more
};
std::vector<BeadDirection> bead_directions(const Toolpath& layer, const PixelGrid& grid);

}  // namespace bead
