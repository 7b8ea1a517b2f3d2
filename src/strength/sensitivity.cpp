#include "strength/sensitivity.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"
#include "fem/pixel_stress.h"
#include "strength/failure_index.h"

namespace bead {
namespace {

constexpr double leaning = 48;  // the norm's p

double highest_of(std::span<const Tested> tested) {
    double highest = 0;
    for (const Tested& of : tested) highest = std::max(highest, of.index[of.weakest]);
    return highest;
}

// Forces at the nodes by which a small displacement changes the norm.
PixelVector change_of_norm(const TestRig& rig, const Tested& tested, double norm) {
    const PixelModel& model = rig.model();
    std::vector<double> weight(tested.index.size());
    for (std::size_t p = 0; p < weight.size(); ++p)
        weight[p] = std::pow(tested.index[p] / norm, leaning - 1);
    weight = averaging_adjoint(model, weight, rig.averaging());
    const std::vector<PlaneTensor> stress = centre_stress(model, tested.displacement);
    std::vector<PlaneTensor> slope(stress.size());
    for (std::size_t p = 0; p < slope.size(); ++p)
        if (model.factor[p] > 0)
            slope[p] = weight[p] / model.factor[p] * failure_slope(stress[p], rig.material());
    return centre_stress_adjoint(model, slope);
}

}  // namespace

double failure_norm(std::span<const Tested> tested) {
    const double highest = highest_of(tested);
    double sum = 0;
    for (const Tested& of : tested)
        for (const double index : of.index) sum += std::pow(index / highest, leaning);
    return highest * std::pow(sum, 1 / leaning);
}

std::vector<PixelVector> sensitivity(const TestRig& rig, std::span<const Tested> tested) {
    BEAD_EXPECTS(tested.size() == rig.variants().size());
    const double norm = failure_norm(tested);
    std::vector<PixelVector> adjoint;
    for (std::size_t v = 0; v < tested.size(); ++v)
        adjoint.push_back(rig.solver(v).solve_only(change_of_norm(rig, tested[v], norm)));
    return adjoint;
}

}  // namespace bead
