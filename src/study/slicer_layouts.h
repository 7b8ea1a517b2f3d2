// What a slicer would print instead: its patterns with one wall or several, at the same deposited
// volume and with the same solid pads. Where the lines happen to lie matters (a pattern's strength
// changes by a third), so each setting is laid out in several places.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/layout.h"

namespace bead {

enum class SlicerPattern { diagonal_grid, grid, triangles, tri_hexagon };
inline constexpr std::array<std::string_view, 4> slicer_pattern_names{"diagonal grid", "grid",
                                                                      "triangles", "tri-hexagon"};

struct SlicerSetting {
    SlicerPattern pattern = SlicerPattern::triangles;
    int walls = 1;
    int phase = 0;  // of `phases` places of the pattern
    int phases = 4;
};
// "triangles, 2 walls"
std::string name_of(const SlicerSetting& setting);

// All patterns with 1 to 4 walls, in so many places.
std::vector<SlicerSetting> slicer_settings(int phases);

// Lines at the distance at which they weigh what the case says, to half a percent; nothing if walls
// and pads alone weigh more, or if no distance is near enough.
std::optional<Layout> slicer_layout(const LoadCase& load_case, const SlicerSetting& setting);

}  // namespace bead
