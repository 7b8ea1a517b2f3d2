#include "study/stress_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/clip.h"
#include "geom/polygon.h"
#include "geom/resample.h"
#include "infill/clear_of_walls.h"
#include "infill/stripes.h"
#include "infill/trimmed_ends.h"
#include "study/fixed_lines.h"

namespace bead {
namespace {

constexpr double solid_from = 0.65, solid_at = 0.85;  // densities between which lines close up
constexpr double closing = 0.25;                      // of the spacing, so that solid becomes solid
constexpr double point_step = 0.4;                    // mm
constexpr int smoothing_passes = 6;
constexpr double steepness = 1.3;       // of area in spacing, where a trial has no neighbour yet
constexpr double first_spacing = 0.65;  // of bead width over density

double smooth_step(double x, double from, double to) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

LineField field_of(const Densities& densities, std::size_t family, double scale,
                   const StressLineOptions& options) {
    const auto direction = [&densities, family](Vec2 p) {
        const Vec2 first = unit(principal(densities.frame(p)).angle);
        return family == 0 ? first : left_of(first);
    };
    const auto spacing = [&densities, family, scale, options](Vec2 p) {
        const double r = densities.density[family](p);
        const double open = std::clamp(scale / std::max(r, 1e-3), options.least, options.most);
        return std::max(options.least, open * (1 - closing * smooth_step(r, solid_from, solid_at)));
    };
    return {direction, spacing};
}

Layout laid(const LoadCase& load_case, const Layout& fixed, const Densities& densities,
            double scale, const StressLineOptions& options) {
    const Region inside = offset(load_case.part, -load_case.print.bead_width / 2);
    std::vector<FamilyLine> lines;
    for (std::size_t family = 0; family < 2; ++family) {
        std::vector<Polyline> raw =
            stripes(load_case.part, field_of(densities, family, scale, options),
                    {.grid = options.grid, .seed = options.seed});
        for (Polyline& line : raw) line = smoothed(resampled(line, point_step), smoothing_passes);
        for (Polyline& line : inside_parts(raw, inside))
            lines.push_back({static_cast<int>(family), std::move(line)});
    }
    std::vector<Polyline> fixed_lines, walls;
    for (const LayoutLine& line : fixed) {
        fixed_lines.push_back(line.points);
        if (line.kind == LineKind::wall) walls.push_back(line.points);
    }
    Layout layout = fixed;
    lines = clear_of_walls(lines, walls, {.near = load_case.print.bead_width - bead_overlap});
    for (FamilyLine& line : trimmed_ends(std::move(lines), fixed_lines, {}))
        layout.push_back(
            {line.family == 0 ? LineKind::tensile : LineKind::compressive, std::move(line.points)});
    return layout;
}

struct ScaleTrial {
    double scale = 0, area = 0;
};

// On a logarithmic scale between the two nearest trials, or else by the usual steepness.
double next_scale(const std::optional<ScaleTrial>& heavy, const std::optional<ScaleTrial>& light,
                  const ScaleTrial& last, double area) {
    if (!heavy || !light)
        return last.scale * std::pow(last.area / area, steepness) *
               (last.area > area ? 1.01 : 0.99);
    const double whole = std::log(heavy->area) - std::log(light->area);
    const double part = std::clamp((std::log(heavy->area) - std::log(area)) / whole, 0.12, 0.88);
    return heavy->scale * std::pow(light->scale / heavy->scale, part);
}

}  // namespace

Layout stress_lines(const LoadCase& load_case, const Layout& fixed, const Densities& densities,
                    const StressLineOptions& options) {
    const double width = load_case.print.bead_width;
    std::optional<ScaleTrial> heavy, light;
    Layout best;
    double least_off = 0, scale = first_spacing;
    for (int trial = 0; trial < options.trials; ++trial) {
        Layout layout = laid(load_case, fixed, densities, scale, options);
        const ScaleTrial last{scale, deposited_area(layout, width)};
        const double off = std::abs(last.area - options.area);
        if (best.empty() || off < least_off) {
            best = std::move(layout);
            least_off = off;
        }
        if (off <= options.tolerance * options.area) break;
        (last.area > options.area ? heavy : light) = last;
        scale = next_scale(heavy, light, last, options.area);
    }
    return best;
}

}  // namespace bead
