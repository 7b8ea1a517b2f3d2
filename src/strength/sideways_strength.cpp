#include "strength/sideways_strength.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/sideways.h"
#include "strength/printed_pixels.h"

namespace bead {
namespace {

constexpr double thin = 10, very_thin = 5;  // bead widths
constexpr double sheet_from = 5;            // thicknesses: what is as wide counts as a sheet
constexpr double coarse_pixels_per_bead = 3;

// mm of solid across a bead at a pixel, looked for up to `most` either way.
double width_across(const PixelModel& model, std::size_t pixel, Vec2 across, double most) {
    const double step = model.grid.size / 2;
    const Vec2 middle = model.grid.centre(pixel);
    double width = step;
    for (const double way : {1.0, -1.0})
        for (double off = step; off <= most; off += step) {
            const auto there = pixel_at(model.grid, middle + way * off * across);
            if (!there || model.factor[*there] == 0) break;
            width += step;
        }
    return width;
}

// The law less a share of its stiffness against shear between a direction and its normal.
PlaneLaw less_shear(const PlaneLaw& law, Vec2 n, double share) {
    const double m[3] = {-2 * n.x * n.y, 2 * n.x * n.y, n.x * n.x - n.y * n.y};
    const double g = -share * law.ss;
    return law + PlaneLaw{g * m[0] * m[0], g * m[0] * m[1], g * m[1] * m[1],
                          g * m[0] * m[2], g * m[1] * m[2], g * m[2] * m[2]};
}

std::vector<PlaneLaw> printed_rigidity(const PixelModel& model, const Toolpath& layer) {
    std::vector<PlaneLaw> rigidity = plate_rigidity(model);
    const std::vector<BeadDirection> beads = bead_directions(layer, model.grid);
    for (std::size_t p = 0; p < rigidity.size(); ++p) {
        if (model.factor[p] == 0 || beads[p].is_crossed) continue;
        const Vec2 along = unit(static_cast<double>(beads[p].angle));
        const double sheet = sheet_from * model.thickness;
        const double width = width_across(model, p, left_of(along), sheet);
        if (width >= sheet) continue;
        rigidity[p] = less_shear(rigidity[p], along, 1 - twist_share(width, model.thickness));
    }
    return rigidity;
}

}  // namespace

bool is_thin(const LoadCase& load_case) {
    const bool thick = load_case.thickness >= thin * load_case.print.bead_width;
    return !load_case.guided.value_or(thick);
}

bool counts_sideways(const LoadCase& load_case) {
    const bool thick = load_case.thickness >= very_thin * load_case.print.bead_width;
    return !load_case.guided.value_or(thick);
}

double twist_share(double width, double thickness) {
    const double narrow = std::min(width, thickness), wide = std::max(width, thickness);
    const double ratio = narrow / wide;
    const double torsion =
        wide * narrow * narrow * narrow * (1.0 / 3 - 0.21 * ratio * (1 - std::pow(ratio, 4) / 12));
    return std::min(1.0, torsion / (width * thickness * thickness * thickness / 3));
}

std::optional<double> sideways_load(std::span<const Toolpath> layers, const LoadCase& load_case,
                                    const SidewaysOptions& options) {
    const double pixel =
        options.pixel > 0 ? options.pixel : load_case.print.bead_width / coarse_pixels_per_bead;
    const std::optional<TestRig> rig = TestRig::of(layers, load_case, {.pixel = pixel});
    if (!rig) return std::nullopt;
    const std::vector<PlaneLaw> rigidity = printed_rigidity(rig->model(), layers.front());
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < rig->variants().size(); ++v) {
        const Variant& variant = rig->variants()[v];
        Situation situation = load_case.situations[variant.situation];
        situation.loads = variant.loads;
        const PixelVector u = rig->solver(v).solve(rig->load(v)).values;
        const auto found = sideways_buckling(rig->model(), rigidity, load_case, situation, u,
                                             load_case.print.bead_width);
        if (!found) return std::nullopt;
        if (found->factor > 0)
            lowest = std::min(lowest, found->factor * total_force(variant.loads));
    }
    return lowest;
}

}  // namespace bead
