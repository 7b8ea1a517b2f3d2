// Fits energy models (energy_models.h) to measured prints and says how far each can be trusted:
// side by side, by every method, on prints that a fit was not shown.
//
//     const Calibration found = calibrate(observations, {EnergyModel::published, …});
//     const FittedModel& best = found.fits[*best_at_new_prints(found)];
#pragma once
#include "energy/energy_models.h"
#include "numeric/bootstrap.h"
#include "numeric/left_out.h"

namespace bead {

// Weighted: by 1 / energy², so that errors count in per cent and long prints do not decide alone.
enum class FitMethod { ordinary, weighted, non_negative };
inline constexpr std::array<std::string_view, 3> fit_method_names{"ordinary", "weighted",
                                                                  "non-negative"};
constexpr std::string_view name_of(FitMethod method) {
    return fit_method_names[std::size_t(method)];
}

struct FittedModel {
    EnergyModel model{};
    FitMethod method{};
    LinearFit fit{};                  // in J
    Bootstrap scatter{};              // of the coefficients
    std::vector<double> estimates{};  // J, per observation
    RelativeErrors shown{};           // of the prints that it was fitted to
    // Of prints left out one by one, of groups left out one by one; nothing where what is left
    // does not determine all coefficients each time.
    std::optional<RelativeErrors> alone{}, by_group{};
};

struct Unfitted {
    EnergyModel model{};
    std::string reason;  // what is missing and what to add, one line
};

struct Calibration {
    std::vector<FittedModel> fits;  // by model, then method
    std::vector<Unfitted> unfitted;
    std::size_t groups = 0;              // different ones; 0 if not every print has one
    std::optional<RelativeErrors> mean;  // of prints left out, each called the mean of the others
};

struct CalibrateOptions {
    ModelOptions model{};
    BootstrapOptions bootstrap{};
    int threads = 0;  // 0: as many as there are cores
};

// Why the model cannot be fitted: a column that is not recorded, fewer prints than coefficients,
// columns that no print tells apart; with what to add. "" if it can.
std::string obstacle(EnergyModel model, const std::vector<Observation>& observations,
                     const ModelOptions& options);

// Expects positive energies.
Calibration calibrate(const std::vector<Observation>& observations,
                      const std::vector<EnergyModel>& models, const CalibrateOptions& options = {});

// The place of the fit with the least error of groups left out, where groups could be; else of
// prints left out. Nothing if no fit was tried on what it had not seen.
std::optional<std::size_t> best_at_new_prints(const Calibration& calibration);

}  // namespace bead
