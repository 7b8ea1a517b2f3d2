// The lines of a reinforced part as SVG: beads in their true width, coloured by what they are for,
// the outline, and a key.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/polygon.h"

namespace bead {

struct PicturedLines {
    std::string name;  // in the key
    std::string_view ink;
    std::vector<Polyline> lines;
};

struct LayoutPicture {
    std::string title, caption;
    Region part;
    double bead_width = 0.6;            // mm
    std::vector<PicturedLines> groups;  // later ones lie on top
};

// A whole SVG file; the same input gives the same bytes.
std::string layout_picture(const LayoutPicture& picture);

}  // namespace bead
