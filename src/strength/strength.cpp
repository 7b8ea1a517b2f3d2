#include "strength/strength.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "strength/anisotropic.h"
#include "strength/coarse_modes.h"
#include "strength/printed_pixels.h"
#include "strength/progressive.h"
#include "strength/sideways_strength.h"

namespace bead {
namespace {

constexpr double pixels_per_bead = 6;
constexpr double coarser = 1.5;    // than the pixels, those on which buckling is tried first
constexpr double far_above = 1.2;  // more than coarse pixels are wrong by, at most 13 % seen
constexpr double buckling_tolerance = 0.01;  // of the load, where the next one is a tenth higher

// mm³ per mm of height.
double volume_per_height(std::span<const Toolpath> layers) {
    double sum = 0, height = 0;
    for (const Toolpath& layer : layers) {
        height += height_of(layer);
        for (const Path& path : layer) sum += volume(path);
    }
    return height > 0 ? sum / height : 0;
}

double covered_area(const PixelModel& model) {
    double sum = 0;
    for (const double share : model.factor) sum += share;
    return sum * model.grid.size * model.grid.size;
}

void weigh(Strength& strength, std::span<const Toolpath> layers, const LoadCase& load_case) {
    strength.volume = volume_per_height(layers) * load_case.thickness;
    strength.mass = strength.volume * load_case.material.density / 1000;
}

// On coarse pixels, and if that is not far above the factor at which it breaks, on the fine ones.
std::optional<double> buckling_factor(const TestRig& rig, std::size_t v, const Tested& tested,
                                      const CoarseModes& coarse, double breaks) {
    const Buckling guess = coarse.of(v);
    if (guess.converged && !guess.modes.empty() && guess.modes.front().factor > far_above * breaks)
        return guess.modes.front().factor;
    const std::vector<BucklingMode> modes =
        rig.modes(v, tested.displacement,
                  {.count = 1,
                   .tolerance = buckling_tolerance,
                   .start = coarse.start(guess, rig.model().grid)});
    if (modes.empty()) return std::nullopt;
    return modes.front().factor;
}

void test_variant(Strength& strength, const TestRig& rig, std::size_t v,
                  const StrengthOptions& options, const std::optional<CoarseModes>& coarse) {
    const double force = total_force(rig.variants()[v].loads);
    const Tested tested = rig.tested(v);
    const double failure = tested.factor() * force;
    strength.stiffness = std::min(strength.stiffness, force * force / tested.work);
    if (failure < strength.failure_load) {
        strength.failure_load = failure;
        strength.weakest = rig.model().grid.centre(tested.weakest);
    }
    if (coarse)
        if (const std::optional<double> factor =
                buckling_factor(rig, v, tested, *coarse, strength.failure_load / force);
            factor && *factor * force < strength.buckling_load) {
            strength.buckling_load = *factor * force;
            strength.buckling_factor = *factor;
        }
    if (options.progressive)
        strength.peak_load =
            std::min(strength.peak_load.value_or(std::numeric_limits<double>::infinity()),
                     peak_factor(rig, v, tested) * force);
}

std::optional<double> finite(std::optional<double> load) {
    return load && std::isfinite(*load) ? load : std::nullopt;
}

}  // namespace

int layer_count(const LoadCase& load_case) {
    return std::max(
        1, static_cast<int>(std::lround(load_case.thickness / load_case.print.layer_height)));
}

Strength strength_of(std::span<const Toolpath> layers, const LoadCase& load_case,
                     const StrengthOptions& options) {
    Strength strength;
    weigh(strength, layers, load_case);
    const double pixel =
        options.pixel > 0 ? options.pixel : load_case.print.bead_width / pixels_per_bead;
    const std::optional<TestRig> rig = TestRig::of(layers, load_case, {.pixel = pixel});
    if (!rig) return strength;
    strength.holds = true;
    strength.covered = covered_area(rig->model());
    constexpr double endless = std::numeric_limits<double>::infinity();
    strength.stiffness = strength.failure_load = strength.buckling_load = endless;
    std::optional<CoarseModes> coarse;
    if (options.buckling) coarse.emplace(layers, load_case, coarser * pixel);
    for (std::size_t v = 0; v < rig->variants().size(); ++v)
        test_variant(strength, *rig, v, options, coarse);
    if (strength.buckling_load == endless) strength.buckling_load = strength.buckling_factor = 0;
    strength.counts_sideways = counts_sideways(load_case);
    if (options.buckling && (options.sideways ? is_thin(load_case) : strength.counts_sideways))
        strength.sideways_load = finite(sideways_load(layers, load_case));
    if (options.anisotropic)
        strength.anisotropic_load = anisotropic_failure_load(layers, load_case, *rig);
    return strength;
}

}  // namespace bead
