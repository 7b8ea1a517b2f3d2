// Quantities over time on top of each other, as a picture: what makes up a power curve.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace bead {

struct Band {
    std::string_view name;
    std::string_view ink;        // as SVG takes it
    std::vector<double> values;  // means over equal steps
};

struct StackedAreas {
    std::string title, caption;
    std::string_view unit;    // "W"
    double step = 1;          // s
    std::vector<Band> bands;  // the lowest first; each has a value for every step
};

// A whole SVG file.
std::string stacked_areas_svg(const StackedAreas& areas);

}  // namespace bead
