// Curves over the angle, as SVG.
#pragma once
#include <string>
#include <vector>

namespace bead::angles {

struct Curve {
    std::string name;
    std::vector<double> values;  // from 0° to 90°
};
struct Panel {
    std::string title;
    std::vector<Curve> curves;  // of the same names in every panel
};
// Panels two abreast, each with every curve as percent above its own least value.
std::string picture(const std::vector<Panel>& panels);

}  // namespace bead::angles
