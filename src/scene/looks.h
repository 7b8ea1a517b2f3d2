// How each role is drawn. Walls are warm, what is solid is green, infill is blue; where hues look
// alike to some, lightness differs. Colours as SVG takes them.
#pragma once
#include <array>
#include <string_view>

#include "toolpath/path.h"

namespace bead {

inline constexpr std::string_view travel_ink = "#6b7280";

struct Look {
    Role role;
    std::string_view name;        // in plain words
    std::string_view edge, body;  // the bead's rim and what is inside it
};

// What stands later is drawn on top, except that travel, a thin line, lies on top of all. The
// legend has the same order from its end.
inline constexpr std::array looks{
    Look{Role::travel, "travel", travel_ink, travel_ink},
    Look{Role::other, "other", "#8e8e8e", "#bdbdbd"},
    Look{Role::skirt, "skirt", "#8674a0", "#b9aacb"},
    Look{Role::support, "support", "#8c8576", "#bdb6a7"},
    Look{Role::infill, "infill", "#2c5a85", "#5790bf"},
    Look{Role::skin, "skin", "#3f746c", "#6fa89e"},
    Look{Role::top_skin, "top skin", "#6d9c84", "#a9d0b9"},
    Look{Role::wall, "wall", "#b5702f", "#ecab6d"},
    Look{Role::outer_wall, "outer wall", "#86351d", "#c75c3b"},
};

}  // namespace bead
