// A second bead beside a line where it would fail first.
#pragma once
#include <optional>
#include <span>

#include "strength/test_rig.h"
#include "study/layout.h"

namespace bead {

struct PatchLineOptions {
    double area = 5;    // mm² of bead that may be spent
    double hot = 0.93;  // of the highest index: what needs help
    double warm = 0.8;  // as far along a line as this goes its copy
    double apart = 4;   // mm between hot spots
    int most = 9;
    int place = 0;  // of those that have room beside the hottest line, the nearest is 0
};

// `index` per pixel, averaged; of several variants the highest. Nothing if the hottest spot has no
// room for another bead.
std::optional<Layout> patch_lines(const Layout& layout, const PixelModel& model,
                                  std::span<const double> index, const LoadCase& load_case,
                                  const PatchLineOptions& options);

}  // namespace bead
