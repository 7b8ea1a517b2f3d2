#include "numeric/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/expects.h"

namespace bead {
namespace {

// In 0 … count - 1; by hand, as the standard's distributions differ between libraries.
std::size_t below(std::size_t count, std::mt19937_64& random) {
    return std::size_t(double(random() >> 11) * 0x1p-53 * double(count));
}

double percentile(std::vector<double>& sorted, double share) {
    const double place = share * double(sorted.size() - 1);
    const auto before = std::size_t(place);
    const std::size_t after = std::min(before + 1, sorted.size() - 1);
    return std::lerp(sorted[before], sorted[after], place - double(before));
}

}  // namespace

Bootstrap bootstrap(const Rows& rows, const std::vector<double>& values, const FitOptions& fit,
                    const BootstrapOptions& options) {
    BEAD_EXPECTS(options.draws > 0 && rows.size() == values.size() && !rows.empty());
    const std::size_t n = rows.size(), p = rows.front().size();
    std::mt19937_64 random(options.seed);
    std::vector<std::vector<double>> found(p);
    for (int draw = 0; draw < options.draws; ++draw) {
        Rows some;
        std::vector<double> their;
        FitOptions how{.non_negative = fit.non_negative};
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t k = below(n, random);
            some.push_back(rows[k]);
            their.push_back(values[k]);
            if (!fit.weights.empty()) how.weights.push_back(fit.weights[k]);
        }
        const LinearFit drawn = fit_linear(some, their, how);
        if (std::isinf(drawn.condition)) continue;
        for (std::size_t j = 0; j < p; ++j) found[j].push_back(drawn.coefficients[j]);
    }
    Bootstrap result{{}, int(found.front().size())};
    if (result.fitted == 0) return result;
    for (std::vector<double>& coefficient : found) {
        std::ranges::sort(coefficient);
        result.coefficients.push_back(
            {percentile(coefficient, 0.025), percentile(coefficient, 0.975)});
    }
    return result;
}

}  // namespace bead
