#include "energy/interval.h"

#include <algorithm>
#include <cmath>

namespace bead {

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
