#include "study/slicer_layouts.h"

#include <fmt/format.h>
#include <cmath>

#include "geom/clip.h"
#include "geom/polygon.h"
#include "infill/fill.h"
#include "study/fixed_lines.h"

namespace bead {
namespace {

constexpr double into_wall = 0.1;         // mm, by which a line's end reaches beyond bead to bead
constexpr double shortest_filling = 0.3;  // mm
constexpr double tolerance = 0.005;       // of the area
constexpr int spacing_halvings = 40, tries = 9;

struct Family {
    double angle = 0;
    double shift = 0;  // of a spacing, across the lines
};

std::vector<Family> families_of(SlicerPattern pattern) {
    switch (pattern) {
        case SlicerPattern::diagonal_grid:
            return {{pi / 4, 0}, {-pi / 4, 0}};
        case SlicerPattern::grid:
            return {{0, 0}, {pi / 2, 0}};
        case SlicerPattern::triangles:
            return {{0, 0}, {pi / 3, 0}, {-pi / 3, 0}};
        case SlicerPattern::tri_hexagon:
            return {{0, 0.5}, {pi / 3, 0}, {-pi / 3, 0}};
    }
    return {};
}

std::vector<Polyline> lines_of(const Region& inside, const SlicerSetting& setting, Vec2 middle,
                               double spacing, double nudge) {
    // Moved by a part of the spacing along both axes: no family keeps its place.
    const double part = static_cast<double>(setting.phase) / setting.phases + nudge;
    const Vec2 from = middle + part * spacing * Vec2{0.6, 1.0};
    std::vector<Polyline> lines;
    for (const Family& family : families_of(setting.pattern))
        for (Polyline& line : rectilinear(
                 inside, {.spacing = spacing,
                         .angle = family.angle,
                         .link = 0,
                         .centre = from + family.shift * spacing * left_of(unit(family.angle))}))
            if (length(line) > shortest_filling) lines.push_back(std::move(line));
    return lines;
}

double line_area(const std::vector<Polyline>& lines, double width) {
    double sum = 0;
    for (const Polyline& line : lines) sum += length(line) * width;
    return sum;
}

}  // namespace

std::string name_of(const SlicerSetting& setting) {
    return fmt::format("{}, {} wall{}",
                       slicer_pattern_names[static_cast<std::size_t>(setting.pattern)],
                       setting.walls, setting.walls == 1 ? "" : "s");
}

std::vector<SlicerSetting> slicer_settings(int phases) {
    std::vector<SlicerSetting> settings;
    for (const SlicerPattern pattern : {SlicerPattern::diagonal_grid, SlicerPattern::grid,
                                        SlicerPattern::triangles, SlicerPattern::tri_hexagon})
        for (int walls = 1; walls <= 4; ++walls)
            for (int phase = 0; phase < phases; ++phase)
                settings.push_back({pattern, walls, phase, phases});
    return settings;
}

std::optional<Layout> slicer_layout(const LoadCase& load_case, const SlicerSetting& setting) {
    const double width = load_case.print.bead_width;
    Layout layout = wall_lines(load_case.part, width, setting.walls);
    for (LayoutLine& line : pad_lines(load_case, setting.walls)) layout.push_back(std::move(line));
    const double whole = load_case.print.fill * area(load_case.part);
    const double wanted = whole - deposited_area(layout, width);
    const Region inside = offset(
        load_case.part, -(setting.walls * (width - bead_overlap) + bead_overlap - into_wall));
    if (wanted <= 0 || inside.empty()) return std::nullopt;
    const Vec2 middle = bounds(load_case.part).centre();
    // The area jumps where a line leaves the part; moved a little it jumps elsewhere.
    for (int attempt = 0; attempt < tries; ++attempt) {
        double low = width / 2, high = 60;
        const double nudge = 0.017 * attempt;
        for (int i = 0; i < spacing_halvings; ++i) {
            const double spacing = std::sqrt(low * high);
            const std::vector<Polyline> lines = lines_of(inside, setting, middle, spacing, nudge);
            const double laid = line_area(lines, width);
            if (std::abs(laid - wanted) <= tolerance * whole) {
                for (const Polyline& line : lines) layout.push_back({LineKind::tensile, line});
                return layout;
            }
            (laid > wanted ? low : high) = spacing;
        }
    }
    return std::nullopt;
}

}  // namespace bead
