#include "vibration/resonance.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"
#include "numeric/least_squares.h"

namespace bead {
namespace {

constexpr double part_of_peak = 0.3;  // what belongs to it
constexpr std::size_t fewest = 5;     // points of a fit of three numbers

struct Stretch {
    std::size_t first = 0, last = 0;
};

Stretch around(std::span<const double> power, std::size_t peak) {
    Stretch s{peak, peak};
    const double least = part_of_peak * power[peak];
    while (s.first > 0 && power[s.first - 1] > least) --s.first;
    while (s.last + 1 < power.size() && power[s.last + 1] > least) ++s.last;
    while (s.last - s.first + 1 < fewest && s.first > 0 && s.last + 1 < power.size()) {
        --s.first;
        ++s.last;
    }
    return s;
}

}  // namespace

std::optional<DriveMode> fitted_mode(std::span<const double> frequency,
                                     std::span<const double> power) {
    BEAD_EXPECTS(frequency.size() == power.size());
    if (power.size() < fewest) return {};
    const auto peak = std::size_t(std::ranges::max_element(power) - power.begin());
    const Stretch s = around(power, peak);
    if (peak == 0 || peak + 1 == power.size() || power[peak] <= 0 || s.last - s.first + 1 < fewest)
        return {};

    DriveMode mode{frequency[peak], 0};
    for (int round = 0; round < 5; ++round) {  // the numerator needs the damping
        Rows rows;
        std::vector<double> values;
        FitOptions options;
        for (std::size_t i = s.first; i <= s.last; ++i) {
            if (power[i] <= 0) return {};
            const double x = std::pow(frequency[i] / frequency[peak], 2),
                         p = power[i] / power[peak];
            rows.push_back({1, x, x * x});
            values.push_back((1 + 4 * mode.damping * mode.damping * x) / p);
            options.weights.push_back(p * p);
        }
        const std::vector<double> c = fit_linear(rows, values, options).coefficients;
        if (c[0] <= 0 || c[2] <= 0) return {};
        const double square = std::sqrt(c[0] / c[2]);  // of f0 over the peak's frequency
        const double damping2 = (c[1] / (c[2] * square) + 2) / 4;
        if (damping2 <= 0) return {};
        mode = {frequency[peak] * std::sqrt(square), std::sqrt(damping2)};
    }
    return mode;
}

}  // namespace bead
