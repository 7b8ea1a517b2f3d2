// One layer drawn as SVG: beads in their true width, coloured by what they are for, travel as thin
// lines.
//
//     const std::vector<Panel> panels{{"before", before, "3.3 kJ"}, {"after", after, "2.9 kJ"}};
//     file.stream() << layer_picture(panels, "Layer 12, z = 2.4 mm");
#pragma once
#include <span>
#include <string>

#include "toolpath/path.h"

namespace bead {

struct Panel {
    std::string title;    // above the panel
    Toolpath layer;       // paths of one layer
    std::string caption;  // below it, e.g. "41.2 s, 3.3 kJ"
};

// Panels side by side at the same scale, with a legend of the roles that occur and a bar of 10 mm
// (or whatever round length fits). Text is escaped. The same input gives the same bytes.
std::string layer_picture(std::span<const Panel> panels, const std::string& title);

}  // namespace bead
