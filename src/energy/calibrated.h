// A model with its coefficients, as fitted, ready to be asked about a print that nobody measured.
#pragma once
#include "energy/calibrate.h"

namespace bead {

struct CalibratedModel {
    EnergyModel model{};
    ModelOptions options{};
    std::vector<double> coefficients{};     // J, as columns_of(model)
    std::vector<double> standard_errors{};  // J
    std::optional<double> error{};  // mean relative error of prints it was not shown, if tried
};

CalibratedModel calibrated(const FittedModel& fit, const ModelOptions& options);

// J. Expects that the print has what the model needs (`lacking`).
double estimate(const CalibratedModel& model, const Observation& print);

}  // namespace bead
