// The nodes of a pixel model that touch something solid, numbered in their order: those that have
// unknowns.
#pragma once
#include <vector>

#include "fem/pixel_model.h"

namespace bead {

struct SolidNumbering {
    std::vector<int> point_of;        // per node; -1: none
    std::vector<std::size_t> nodes;   // per point
    std::vector<std::size_t> pixels;  // that are solid
};

SolidNumbering solid_numbering(const PixelModel& model);

}  // namespace bead
