// Guesses of a printed structure's buckling modes from coarser pixels, on which finding them costs
// a fraction: a start for the search on the fine ones, which then takes a few steps. What it finds
// does not depend on them, only how soon.
#pragma once
#include <span>
#include <vector>

#include "strength/test_rig.h"

namespace bead {

// Each node of the grid takes the mean of the nodes of the coarser model around it that touch
// something solid, weighted by nearness; where there are none, 0.
PixelVector transferred(const PixelModel& coarse, std::span<const double> shape,
                        const PixelGrid& grid);

// Per variant of the rig its lowest modes, as vectors over the nodes of `grid`. Empty where the
// layers do not hold together on coarse pixels.
class CoarseModes {
  public:
    CoarseModes(std::span<const Toolpath> layers, const LoadCase& load_case, double fine_pixel);
    [[nodiscard]] std::vector<PixelVector> start(std::size_t variant, const PixelGrid& grid) const;

  private:
    std::optional<TestRig> rig_;
};

}  // namespace bead
