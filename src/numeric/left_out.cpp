#include "numeric/left_out.h"

#include <cmath>
#include <numeric>
#include <set>

#include "core/expects.h"

namespace bead {
namespace {

struct Kept {
    Rows rows;
    std::vector<double> values;
    FitOptions options;
};

Kept all_but(std::size_t label, const Rows& rows, const std::vector<double>& values,
             const std::vector<std::size_t>& labels, const FitOptions& options) {
    Kept kept{{}, {}, {.non_negative = options.non_negative}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (labels[i] == label) continue;
        kept.rows.push_back(rows[i]);
        kept.values.push_back(values[i]);
        if (!options.weights.empty()) kept.options.weights.push_back(options.weights[i]);
    }
    return kept;
}

std::optional<std::vector<double>> coefficients(const Kept& kept, std::size_t count) {
    if (kept.rows.size() < count) return std::nullopt;
    LinearFit fit = fit_linear(kept.rows, kept.values, kept.options);
    if (std::isinf(fit.condition)) return std::nullopt;
    return std::move(fit.coefficients);
}

}  // namespace

std::vector<std::size_t> each_alone(std::size_t count) {
    std::vector<std::size_t> labels(count);
    std::iota(labels.begin(), labels.end(), 0);
    return labels;
}

std::vector<std::optional<double>> left_out(const Rows& rows, const std::vector<double>& values,
                                            const std::vector<std::size_t>& labels,
                                            const FitOptions& options) {
    BEAD_EXPECTS(rows.size() == values.size() && rows.size() == labels.size());
    std::vector<std::optional<double>> told(rows.size());
    for (const std::size_t label : std::set<std::size_t>(labels.begin(), labels.end())) {
        const auto fitted =
            coefficients(all_but(label, rows, values, labels, options), rows.front().size());
        if (!fitted) continue;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (labels[i] == label) told[i] = dot(rows[i], *fitted);
    }
    return told;
}

std::optional<RelativeErrors> relative_errors(const std::vector<std::optional<double>>& told,
                                              const std::vector<double>& values) {
    RelativeErrors errors;
    for (std::size_t i = 0; i < told.size(); ++i) {
        if (!told[i]) continue;
        const double error = *told[i] / values[i] - 1;
        ++errors.told;
        errors.mean_absolute += std::abs(error);
        if (std::abs(error) > std::abs(errors.worst)) {
            errors.worst = error;
            errors.worst_row = i;
        }
    }
    if (errors.told == 0) return std::nullopt;
    errors.mean_absolute /= double(errors.told);
    return errors;
}

}  // namespace bead
