// Whether the walls still fill what they are there for: the band of the part within some distance
// of its outline, against what the beads cover, each as wide as its
// spacing (toolpath/path.h), for so wide it fills the layer's height.
//
//     const Coverage now = wall_coverage(layer, section, 1.2);   // three walls of 0.4 mm
#pragma once
#include "geom/polygon.h"
#include "toolpath/path.h"

namespace bead {

struct Coverage {                  // mm²; mm
    double band = 0;               // area of the band
    double underfill = 0;          // of the band, not covered by a wall
    double overfill = 0;           // of walls, laid where a wall was already
    double outside = 0;            // of walls, outside the part
    double outline_deviation = 0;  // largest distance from the part's outline to the edge of the
                                   // outer walls' beads, or from that edge, outside, to the
                                   // outline; beads are round at corners, so those of the part
                                   // count as far as such a bead reaches
};

// One layer. The outline is the part's, curves flattened finely if it is to be the true one.
Coverage wall_coverage(const Toolpath& layer, const Region& outline, double band);

}  // namespace bead
