// Layers to plan with, made by hand: no mesh, no slicing. Lengths in mm.
#pragma once
#include <string>
#include <vector>

#include "geom/clip.h"
#include "shapes.h"
#include "slice/slice.h"

namespace bead::shapes {

inline constexpr double layer_height = 0.2;

// Layers of these regions, one on the other.
inline std::vector<Layer> stacked(const std::vector<Region>& regions) {
    std::vector<Layer> layers;
    for (const Region& region : regions) {
        const double z = layer_height * static_cast<double>(layers.size() + 1);
        layers.push_back({z, layer_height, region});
    }
    return layers;
}

inline std::vector<Layer> prism(const Region& region, int layers) {
    return stacked(std::vector<Region>(static_cast<std::size_t>(layers), region));
}

inline Region rectangle(Vec2 low, Vec2 high) {
    return {{{low, {high.x, low.y}, high, {low.x, high.y}}, {}}};
}
inline Region ell() { return {{{{0, 0}, {40, 0}, {40, 12}, {14, 12}, {14, 30}, {0, 30}}, {}}}; }
inline Region ring(double outer, double inner) {
    return difference({{regular(outer, 64), {}}}, {{regular(inner, 64), {}}});
}
inline Region star(std::uint64_t seed) { return {{random_star(seed, 16, 12, 22), {}}}; }

struct NamedRegion {
    std::string name;
    Region region;
};
inline std::vector<NamedRegion> some_regions() {
    return {{"box", rectangle({0, 0}, {30, 20})},
            {"ell", ell()},
            {"ring", ring(20, 9)},
            {"two islands", united(rectangle({0, 0}, {12, 15}), rectangle({20, 3}, {40, 16}))},
            {"star 1", star(1)},
            {"star 2", star(2)}};
}

// A pyramid of square steps about the origin, `thick` layers each.
inline std::vector<Layer> stepped_pyramid(const std::vector<double>& widths, int thick) {
    std::vector<Region> regions;
    for (const double width : widths)
        for (int i = 0; i < thick; ++i)
            regions.push_back(rectangle({-width / 2, -width / 2}, {width / 2, width / 2}));
    return stacked(regions);
}

}  // namespace bead::shapes
