#include "strength/test_rig.h"

#include <algorithm>

#include "core/expects.h"
#include "fem/pixel_boundary.h"
#include "fem/pixel_stress.h"
#include "fem/stretch.h"
#include "strength/failure_index.h"
#include "strength/printed_pixels.h"
#include "strength/usual_scale.h"

namespace bead {
namespace {

// The share of the height over which a pixel is solid.
std::vector<double> mean_of(std::span<const Toolpath> layers, const PixelGrid& grid) {
    double height = 0;
    for (const Toolpath& layer : layers) height += height_of(layer);
    std::vector<double> mean(grid.pixels(), 0.0);
    for (const Toolpath& layer : layers) {
        const double share = height_of(layer) / height;
        if (!(share > 0)) continue;
        const std::vector<double> solid = printed_pixels(layer, grid);
        for (std::size_t p = 0; p < mean.size(); ++p) mean[p] += share * solid[p];
    }
    return mean;
}

void append(std::vector<Polyline>& lines, const Region& part, const Stretch& stretch) {
    const std::optional<std::vector<Polyline>> more = stretch_lines(part, stretch);
    BEAD_EXPECTS(more);
    lines.insert(lines.end(), more->begin(), more->end());
}

std::vector<Polyline> loaded_lines(const LoadCase& load_case,
                                   const std::vector<Variant>& variants) {
    std::vector<Polyline> lines;
    for (const Variant& variant : variants)
        for (const Load& load : variant.loads) append(lines, load_case.part, load.on);
    return lines;
}

// As the beads' width and the part's size ask for.
RigOptions at_scale(RigOptions options, const LoadCase& load_case) {
    constexpr double most_excluded = 0.15;  // of the part's diagonal
    const double scale = usual_scale(load_case.print);
    options.averaging /= scale;
    options.excluded =
        std::min(options.excluded / scale, most_excluded * length(bounds(load_case.part).size()));
    return options;
}

// Where nothing solid is far from loads and supports, all of it is judged.
std::vector<std::uint8_t> judged_pixels(const PixelModel& model,
                                        const std::vector<Polyline>& patches, double excluded) {
    std::vector<std::uint8_t> judged = far_from(model.grid, patches, excluded);
    for (std::size_t p = 0; p < judged.size(); ++p)
        if (judged[p] != 0 && model.factor[p] > 0) return judged;
    judged.assign(judged.size(), 1);
    return judged;
}

std::vector<Vec2> middles(const std::vector<Polyline>& lines) {
    std::vector<Vec2> places;
    places.reserve(lines.size());
    for (const Polyline& line : lines) places.push_back(line[line.size() / 2]);
    return places;
}

}  // namespace

std::optional<TestRig> TestRig::of(std::span<const Toolpath> layers, const LoadCase& load_case,
                                   const RigOptions& options) {
    TestRig rig;
    rig.material_ = load_case.material;
    rig.options_ = at_scale(options, load_case);
    rig.variants_ = load_variants(load_case);
    std::vector<Polyline> patches = loaded_lines(load_case, rig.variants_);
    PixelModel model;
    model.grid = grid_over(bounds(load_case.part), options.pixel);
    model.thickness = load_case.thickness;
    model.law = isotropic(load_case.material.young, load_case.material.poisson);
    const double reach = load_case.print.bead_width;
    model.factor = connected(mean_of(layers, model.grid), model.grid, middles(patches), reach);
    for (const Situation& situation : load_case.situations) {
        const std::optional<Held> held =
            held_nodes(model, load_case.part, situation.supports, {reach});
        if (!held) return std::nullopt;
        rig.solvers_.emplace_back(model, *held);
        if (rig.solvers_.back().loose_node()) return std::nullopt;
        for (const Support& support : situation.supports)
            append(patches, load_case.part, support.on);
    }
    for (const Variant& variant : rig.variants_) {
        std::optional<PixelVector> load =
            load_vector(model, load_case.part, variant.loads, {reach});
        if (!load) return std::nullopt;
        rig.loads_.push_back(std::move(*load));
    }
    rig.judged_ = judged_pixels(model, patches, rig.options_.excluded);
    return rig;
}

Tested TestRig::judged(const PixelModel& model, std::vector<double> displacement,
                       std::size_t variant) const {
    Tested tested;
    tested.work = work(loads_[variant], displacement);
    const std::vector<PlaneTensor> stress = centre_stress(model, displacement);
    std::vector<double> index(stress.size(), 0.0);
    for (std::size_t p = 0; p < stress.size(); ++p)
        // Stress is the layer's mean; the plastic's own is higher where it does not fill all
        // layers.
        if (model.factor[p] > 0)
            index[p] = failure_index((1 / model.factor[p]) * stress[p], material_);
    tested.index = averaged_over_solid(model, index, options_.averaging);
    for (std::size_t p = 0; p < index.size(); ++p)
        if (!judged_[p]) tested.index[p] = 0;
    tested.weakest =
        static_cast<std::size_t>(std::ranges::max_element(tested.index) - tested.index.begin());
    tested.displacement = std::move(displacement);
    return tested;
}

Tested TestRig::tested(std::size_t variant) const {
    return judged(model(), solver(variant).solve(loads_[variant]).values, variant);
}

std::vector<BucklingMode> TestRig::modes(std::size_t variant, std::span<const double> displacement,
                                         const BucklingOptions& options) const {
    return buckling(solver(variant), displacement, options).modes;
}

}  // namespace bead
