// The beads of a print that belong to its part: skirts, brims' neighbours, lines that prime the
// nozzle and further copies lie apart from it, whether a file names them or not. Beads that touch
// in any layer, seen from above, hang together; what hangs together and weighs most is the part.
#pragma once
#include <vector>

#include "geom/box.h"
#include "toolpath/path.h"

namespace bead {

struct PartBeads {
    std::vector<Toolpath> layers;  // without travel; none is empty
    double left_out = 0;           // mm³, of beads without a role that lay apart
};

PartBeads part_beads(std::vector<Toolpath> layers);

// What the beads cover, half their width beyond their middle lines.
Box2 covered_box(const std::vector<Toolpath>& layers);
// mm, by which beads cover the plane, each by its weight.
double mean_width(const std::vector<Toolpath>& layers);

}  // namespace bead
