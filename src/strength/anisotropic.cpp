#include "strength/anisotropic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/pixel_stress.h"
#include "strength/failure_index.h"
#include "strength/printed_pixels.h"
#include "strength/usual_scale.h"

namespace bead {
namespace {

constexpr double averaging = 0.6;  // mm

PlaneLaw bead_law(const SolidMaterial& material, const BeadAnisotropy& beads, double angle) {
    const double along = material.young, across = beads.across_stiffness * along;
    const double n = 1 - material.poisson * material.poisson * across / along;
    const double d1 = along / n, d2 = across / n, d12 = material.poisson * across / n;
    const double shear = std::sqrt(along * across) / (2 * (1 + material.poisson));
    const double c = std::cos(angle), s = std::sin(angle), c2 = c * c, s2 = s * s, cs = c * s;
    PlaneLaw law;
    law.xx = c2 * c2 * d1 + 2 * c2 * s2 * (d12 + 2 * shear) + s2 * s2 * d2;
    law.yy = s2 * s2 * d1 + 2 * c2 * s2 * (d12 + 2 * shear) + c2 * c2 * d2;
    law.xy = c2 * s2 * (d1 + d2 - 4 * shear) + (c2 * c2 + s2 * s2) * d12;
    law.xs = cs * (c2 * (d1 - d12 - 2 * shear) - s2 * (d2 - d12 - 2 * shear));
    law.ys = cs * (s2 * (d1 - d12 - 2 * shear) - c2 * (d2 - d12 - 2 * shear));
    law.ss = c2 * s2 * (d1 + d2 - 2 * d12) + (c2 - s2) * (c2 - s2) * shear;
    return law;
}

PixelModel with_bead_laws(PixelModel model, const std::vector<BeadDirection>& directions,
                          const SolidMaterial& material, const BeadAnisotropy& beads) {
    model.laws.assign(model.factor.size(), model.law);
    for (std::size_t p = 0; p < model.laws.size(); ++p)
        if (model.factor[p] > 0 && !directions[p].is_crossed)
            model.laws[p] = bead_law(material, beads, static_cast<double>(directions[p].angle));
    return model;
}

double square(double x) { return x * x; }

}  // namespace

double hashin_index(PlaneTensor s, const SolidMaterial& material, const BeadAnisotropy& beads) {
    const double shear = square(s.xy / (beads.shear_strength * material.tensile));
    const double along =
        s.xx > 0 ? square(s.xx / material.tensile) + shear : square(s.xx / material.compressive);
    const double bears = s.yy > 0 ? beads.across_strength * material.tensile : material.compressive;
    return std::sqrt(std::max(along, square(s.yy / bears) + shear));
}

double anisotropic_failure_load(std::span<const Toolpath> layers, const LoadCase& load_case,
                                const TestRig& rig, const BeadAnisotropy& beads) {
    const std::vector<BeadDirection> directions = bead_directions(layers.front(), rig.model().grid);
    const PixelModel model = with_bead_laws(rig.model(), directions, load_case.material, beads);
    std::vector<PixelSolver> solvers;
    for (std::size_t v = 0; v < rig.variants().size(); ++v)
        if (rig.variants()[v].situation == solvers.size())
            solvers.emplace_back(model, rig.solver(v).held());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < rig.variants().size(); ++v) {
        const Displacement moved = solvers[rig.variants()[v].situation].solve(rig.load(v));
        const std::vector<PlaneTensor> stress = centre_stress(model, moved.values);
        std::vector<double> index(stress.size(), 0.0);
        for (std::size_t p = 0; p < stress.size(); ++p) {
            if (model.factor[p] <= 0) continue;
            const PlaneTensor own = (1 / model.factor[p]) * stress[p];
            const double angle = static_cast<double>(directions[p].angle);
            index[p] = directions[p].is_crossed
                           ? failure_index(own, load_case.material) / beads.crossing
                           : hashin_index(rotated(own, unit(-angle)), load_case.material, beads);
        }
        const std::vector<double> mean =
            averaged_over_solid(model, index, averaging / usual_scale(load_case.print));
        double highest = 0;
        for (std::size_t p = 0; p < mean.size(); ++p)
            if (rig.is_judged()[p]) highest = std::max(highest, mean[p]);
        least = std::min(least, total_force(rig.variants()[v].loads) / highest);
    }
    return least;
}

}  // namespace bead
