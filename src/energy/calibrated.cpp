#include "energy/calibrated.h"

namespace bead {

CalibratedModel calibrated(const FittedModel& fit, const ModelOptions& options) {
    CalibratedModel model{fit.model, options, fit.fit.coefficients, fit.fit.standard_errors};
    if (const auto& errors = fit.by_group ? fit.by_group : fit.alone)
        model.error = errors->mean_absolute;
    return model;
}

double estimate(const CalibratedModel& model, const Observation& print) {
    return dot(row_of(model.model, print, model.options), model.coefficients);
}

}  // namespace bead
