// A printed structure's buckling modes on coarser pixels, on which finding them costs a fraction:
// enough where it breaks long before it buckles, and else the start of the search on the fine ones,
// which then takes a few steps.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "strength/test_rig.h"

namespace bead {

// Each node of the grid takes the mean of the nodes of the coarser model around it that touch
// something solid, weighted by nearness; where there are none, 0.
PixelVector transferred(const PixelModel& coarse, std::span<const double> shape,
                        const PixelGrid& grid);

class CoarseModes {
  public:
    CoarseModes(std::span<const Toolpath> layers, const LoadCase& load_case, double pixel);

    // The lowest modes of a variant; nothing found where the layers do not hold together on coarse
    // pixels.
    [[nodiscard]] Buckling of(std::size_t variant) const;
    // The same as vectors over the nodes of `grid`.
    [[nodiscard]] std::vector<PixelVector> start(const Buckling& coarse,
                                                 const PixelGrid& grid) const;

  private:
    // `tolerance` of the lowest factor.
    [[nodiscard]] Buckling within(double tolerance, std::size_t variant) const;

    std::optional<TestRig> rig_;
    std::unique_ptr<CoarseModes> coarser_;  // its own start, if that saves anything
};

}  // namespace bead
