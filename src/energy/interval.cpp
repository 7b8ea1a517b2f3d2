#include "energy/interval.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bead {

namespace {

using Terms = std::array<double, 4>;  // A, B, C, H

// Standard errors (J per unit) and correlations of the coefficients: least squares through the
// origin on Table 3 of Somade (2023); so is the residual, J.
constexpr Terms standard_error{3.18727693e-5, 2.11515088e-5, 3.97905380e-3, 0.134870611};
constexpr std::array<Terms, 4> correlation{{{1, -0.32463069, -0.64916269, 0.19600612},
                                            {-0.32463069, 1, -0.08506255, -0.56159289},
                                            {-0.64916269, -0.08506255, 1, -0.43141797},
                                            {0.19600612, -0.56159289, -0.43141797, 1}}};
constexpr double residual = 100.1529;
constexpr double student_95_of_6 = 2.446912;

Interval around(double energy, const Terms& features) {
    double variance = residual * residual;
    for (std::size_t i = 0; i < features.size(); ++i)
        for (std::size_t j = 0; j < features.size(); ++j)
            variance += features[i] * features[j] * standard_error[i] * standard_error[j] *
                        correlation[i][j];
    const double reach = student_95_of_6 * std::sqrt(variance);
    return {std::max(0.0, energy - reach), energy + reach};
}

}  // namespace

Interval published_interval_95(const Features& f) {
    return around(published_energy(f), {f.A, f.B, f.C, f.H});
}

// kC' C + kH (axis time) = kC C + kH (axis time - C / usual speed).
Interval standing_interval_95(const Features& f, double usual_speed) {
    return around(standing_form(f, {}, usual_speed),
                  {f.A, f.B, f.C, f.axis_time - f.C / usual_speed});
}

Interval interval_95(const Energy& energy, const PowerModel& power) {
    constexpr double normal_95 = 1.959964;  // standard deviations either side
    const PowerUncertainty& u = power.uncertainty;
    const double supplied = total(energy) - (power.bed.mains ? energy.bed : 0);
    double variance = 0;
    for (const double off :
         {u.bed * energy.bed, u.hotend * energy.hotend, u.motors * energy.motors,
          u.fans * energy.fans, u.electronics * energy.electronics, u.supply * supplied})
        variance += off * off;
    const double reach = normal_95 * std::sqrt(variance);
    return {std::max(0.0, total(energy) - reach), total(energy) + reach};
}

}  // namespace bead
