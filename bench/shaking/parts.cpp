#include "parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "geom/clip.h"
#include "mesh/load.h"
#include "slice/slice.h"
#include "smooth/engine_block.h"

namespace bead::shaking {
namespace {

Polyline circle(Vec2 middle, double radius, int corners) {
    Polyline loop;
    for (int i = 0; i < corners; ++i) loop.push_back(middle + radius * unit(2 * pi * i / corners));
    return loop;
}

Polyline box(Vec2 low, Vec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

// Teeth with straight flanks, as many an STL has them.
Region gear(int teeth, double inner, double outer, double bore) {
    Polyline loop;
    for (int i = 0; i < teeth; ++i)
        for (const auto& [share, radius] :
             {std::pair{0.0, inner}, {0.25, inner}, {0.38, outer}, {0.62, outer}, {0.75, inner}})
            loop.push_back(radius * unit(2 * pi * (i + share) / teeth));
    return difference({{loop, {}}}, {{circle({}, bore, 48), {}}});
}

// "HEFLT" of bars 7 mm wide.
Region letters() {
    const auto joined = [](const std::vector<Polyline>& bars, double x) {
        Region letter;
        for (const Polyline& bar : bars)
            letter = united(letter, moved(Region{{bar, {}}}, 0, {}, {x, 0}));
        return letter;
    };
    const Polyline stem = box({0, 0}, {7, 40}), top = box({0, 33}, {24, 40}),
                   middle = box({0, 17}, {20, 24}), foot = box({0, 0}, {24, 7});
    Region text = joined({stem, middle, box({17, 0}, {24, 40})}, 0);
    text = united(text, joined({stem, top, middle, foot}, 30));
    text = united(text, joined({stem, top, middle}, 60));
    text = united(text, joined({stem, foot}, 90));
    return united(text, joined({top, box({8.5, 0}, {15.5, 40})}, 120));
}

Region blob(double radius, int waves, double depth, int corners) {
    Polyline loop;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * i / corners;
        loop.push_back(
            radius *
            (1 + depth * std::sin(waves * angle) + depth / 2 * std::cos((waves + 2) * angle)) *
            unit(angle));
    }
    return {{loop, {}}};
}

}  // namespace

std::vector<Part> engine_block_sections() {
    std::vector<Part> parts;
    for (const int height : engine_block_heights)
        parts.push_back({fmt::format("W16 {} %", height), engine_block(height)});
    return parts;
}

std::vector<Part> drawn_parts() {
    return {{"gear", gear(24, 36, 42, 10)},
            {"text", letters()},
            {"blob", blob(35, 5, 0.15, 160)},
            {"blob 2", blob(50, 3, 0.2, 90)}};
}

std::optional<Part> section_of(const std::string& name, const std::string& file, double share) {
    if (!std::filesystem::exists(file)) {
        fmt::print(stderr, "{}: left out, {} is not there\n", name, file);
        return std::nullopt;
    }
    Mesh mesh = load_mesh(file);
    const Slices slices = slice(mesh, {});
    const auto at = static_cast<std::size_t>(share * static_cast<double>(slices.layers.size()));
    return Part{name, slices.layers[std::min(at, slices.layers.size() - 1)].region};
}

}  // namespace bead::shaking
