#include "numeric/outlying.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <random>

namespace bead {
namespace {

std::vector<std::size_t> some_rows(std::vector<std::size_t>& all, std::size_t count,
                                   std::mt19937_64& random) {
    for (std::size_t i = 0; i < count; ++i) {
        const auto left = double(all.size() - i);
        std::swap(all[i], all[i + std::size_t(double(random() >> 11) * 0x1p-53 * left)]);
    }
    return {all.begin(), all.begin() + std::ptrdiff_t(count)};
}

// A fit of some rows in relative errors; nothing unless they decide one that makes sense of all.
struct Agreement {
    std::vector<double> ratios;  // value / estimate, per row
    double spread = 0;           // standard deviation of those of the chosen rows
};

std::optional<Agreement> agreement(const Rows& rows, const std::vector<double>& values,
                                   const std::vector<std::size_t>& chosen) {
    Rows few;
    for (const std::size_t i : chosen) {
        few.push_back(rows[i]);
        for (double& x : few.back()) x /= values[i];
    }
    const LinearFit fit = fit_linear(few, std::vector<double>(few.size(), 1));
    if (std::isinf(fit.condition)) return std::nullopt;
    Agreement found{{}, fit.residual};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double estimate = dot(rows[i], fit.coefficients);
        if (estimate <= 0) return std::nullopt;
        found.ratios.push_back(values[i] / estimate);
    }
    return found;
}

double median_error(const std::vector<double>& ratios) {
    std::vector<double> errors;
    errors.reserve(ratios.size());
    for (const double ratio : ratios) errors.push_back(std::abs(ratio - 1));
    const auto middle = errors.begin() + std::ptrdiff_t(errors.size() / 2);
    std::ranges::nth_element(errors, middle);
    return *middle;
}

}  // namespace

std::vector<OutlyingRow> outlying(const Rows& rows, const std::vector<double>& values,
                                  const OutlyingOptions& options) {
    if (rows.empty() || rows.size() < rows.front().size() + 3) return {};
    const std::size_t n = rows.size(), p = rows.front().size();
    std::mt19937_64 random(options.seed);
    std::vector<std::size_t> all(n);
    std::iota(all.begin(), all.end(), 0);
    std::optional<Agreement> best;
    double least = std::numeric_limits<double>::infinity();
    for (int trial = 0; trial < options.trials; ++trial) {
        auto tried = agreement(rows, values, some_rows(all, p, random));
        if (!tried) continue;
        const double error = median_error(tried->ratios);
        if (error >= least) continue;
        least = error;
        best = std::move(tried);
    }
    if (!best) return {};
    // 1.4826 makes a median of normal errors their standard deviation; the rest is Rousseeuw's
    // correction for few rows, which a fit through some of them flatters.
    double sigma = std::max(options.least, 1.4826 * (1 + 5 / double(n - p)) * least);
    // His second step: a common fit of all rows that are not doubtful, which knows the noise
    // better.
    std::vector<std::size_t> sound;
    for (std::size_t i = 0; i < n; ++i)
        if (std::abs(best->ratios[i] - 1) <= 2.5 * sigma) sound.push_back(i);
    if (auto again = agreement(rows, values, sound); again && sound.size() > p) best = again;
    sigma = std::max(sigma, best->spread);
    std::vector<OutlyingRow> found;
    for (std::size_t i = 0; i < n; ++i)
        if (const double off = std::abs(best->ratios[i] - 1) / sigma; off > options.sigmas)
            found.push_back({i, best->ratios[i], off});
    return found;
}

}  // namespace bead
