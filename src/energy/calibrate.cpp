#include "energy/calibrate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/expects.h"
#include "core/parallel.h"
#include "energy/obstacle.h"

namespace bead {
namespace {

std::vector<double> energies_of(const std::vector<Observation>& observations) {
    std::vector<double> energies;
    for (const Observation& seen : observations) {
        BEAD_EXPECTS(seen.energy > 0);
        energies.push_back(seen.energy);
    }
    return energies;
}

// A number per group, in the order of appearance; empty unless each print has one.
std::vector<std::size_t> group_labels(const std::vector<Observation>& observations) {
    std::map<std::string, std::size_t> numbers;
    std::vector<std::size_t> labels;
    for (const Observation& seen : observations) {
        if (seen.group.empty()) return {};
        labels.push_back(numbers.emplace(seen.group, numbers.size()).first->second);
    }
    return labels;
}

FitOptions options_of(FitMethod method, const std::vector<double>& energies) {
    FitOptions options{.non_negative = method == FitMethod::non_negative};
    if (method == FitMethod::weighted)
        for (const double energy : energies) options.weights.push_back(1 / (energy * energy));
    return options;
}

std::optional<RelativeErrors> errors_left_out(const Rows& rows, const std::vector<double>& energies,
                                              const std::vector<std::size_t>& labels,
                                              const FitOptions& options) {
    auto errors = relative_errors(left_out(rows, energies, labels, options), energies);
    if (errors && errors->told < energies.size()) return std::nullopt;
    return errors;
}

struct Measured {
    std::vector<double> energies;
    std::vector<std::size_t> groups;  // empty if there are fewer than two
};

FittedModel fitted(FittedModel result, const Rows& rows, const Measured& measured,
                   const BootstrapOptions& draws) {
    const FitOptions options = options_of(result.method, measured.energies);
    result.fit = fit_linear(rows, measured.energies, options);
    for (const Row& row : rows) result.estimates.push_back(dot(row, result.fit.coefficients));
    result.shown =
        *relative_errors({result.estimates.begin(), result.estimates.end()}, measured.energies);
    result.alone = errors_left_out(rows, measured.energies, each_alone(rows.size()), options);
    if (!measured.groups.empty())
        result.by_group = errors_left_out(rows, measured.energies, measured.groups, options);
    result.scatter = bootstrap(rows, measured.energies, options, draws);
    return result;
}

std::optional<RelativeErrors> errors_of_mean(const std::vector<double>& energies) {
    if (energies.size() < 2) return std::nullopt;
    const Rows ones(energies.size(), Row{1});
    return errors_left_out(ones, energies, each_alone(energies.size()), {});
}

}  // namespace

std::string obstacle(EnergyModel model, const std::vector<Observation>& observations,
                     const ModelOptions& options) {
    const auto columns = columns_of(model);
    const std::size_t n = observations.size(), p = columns.size();
    Rows rows;
    for (const Observation& seen : observations) {
        if (const auto lack = lacking(model, seen); !lack.empty()) return lack_of(lack, seen.name);
        rows.push_back(row_of(model, seen, options));
    }
    if (n < p) return too_few(n, p);
    return indistinct_columns(rows, columns);
}

Calibration calibrate(const std::vector<Observation>& observations,
                      const std::vector<EnergyModel>& models, const CalibrateOptions& options) {
    Measured measured{energies_of(observations), group_labels(observations)};
    Calibration result;
    if (!measured.groups.empty()) result.groups = std::ranges::max(measured.groups) + 1;
    if (result.groups < 2) measured.groups.clear();
    result.mean = errors_of_mean(measured.energies);
    for (const EnergyModel model : models) {
        if (std::string reason = obstacle(model, observations, options.model); !reason.empty()) {
            result.unfitted.push_back({model, std::move(reason)});
            continue;
        }
        for (std::size_t k = 0; k < fit_method_names.size(); ++k)
            result.fits.push_back({.model = model, .method = FitMethod(k)});
    }
    parallel_for(result.fits.size(), options.threads, [&](std::size_t i) {
        Rows rows;
        for (const Observation& seen : observations)
            rows.push_back(row_of(result.fits[i].model, seen, options.model));
        result.fits[i] = fitted(std::move(result.fits[i]), rows, measured, options.bootstrap);
    });
    return result;
}

std::optional<std::size_t> best_at_new_prints(const Calibration& calibration) {
    const bool grouped = std::ranges::any_of(
        calibration.fits, [](const FittedModel& fit) { return fit.by_group.has_value(); });
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < calibration.fits.size(); ++i) {
        const FittedModel& fit = calibration.fits[i];
        const auto& errors = grouped ? fit.by_group : fit.alone;
        if (!errors || errors->mean_absolute >= least) continue;
        least = errors->mean_absolute;
        best = i;
    }
    return best;
}

}  // namespace bead
