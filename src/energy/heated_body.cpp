#include "energy/heated_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/expects.h"

namespace bead {

namespace {

// s: who is that close to the target is there. A wait that was cut into pieces ends as one that was
// not.
constexpr double rounding = 1e-9;

}  // namespace

HeatedBody::HeatedBody(double max_power, double capacity, double ambient)
    : max_power_(max_power),
      capacity_(capacity),
      ambient_(ambient),
      temperature_(ambient),
      target_(ambient) {
    BEAD_EXPECTS(max_power <= 0 || capacity > 0);
}

void HeatedBody::aim(double celsius) { target_ = std::max(celsius, ambient_); }

// `rest` is the temperature that the present power leads to; infinity if the target is not on the
// way.
double HeatedBody::time_to_target(double rest, double time_constant) const {
    const double ratio = (rest - temperature_) / (rest - target_);
    return ratio > 1 ? time_constant * std::log(ratio) : std::numeric_limits<double>::infinity();
}

double HeatedBody::warm_up_time(double conductance, double load) const {
    if (max_power_ <= 0 || temperature_ >= target_) return 0;
    const double rest = ambient_ + (max_power_ - load) / conductance;
    const double time_constant = capacity_ / conductance;
    return std::min(time_to_target(rest, time_constant), 5 * time_constant);
}

HeatDraw HeatedBody::advance(double seconds, double conductance, double load) {
    if (max_power_ <= 0 || seconds <= 0) return {};
    const double drain = target_ > ambient_ ? load : 0;
    const double holding = conductance * (target_ - ambient_) + drain;
    if (temperature_ == target_ && holding <= max_power_)
        return {holding * seconds, (target_ - ambient_) * seconds, holding};

    const double power = temperature_ <= target_ ? max_power_ : 0;
    const double rest = ambient_ + (power - drain) / conductance;
    const double time_constant = capacity_ / conductance;
    const double arrival = time_to_target(rest, time_constant);
    const bool arrives = arrival <= seconds + rounding;
    const double way = std::min(arrival, seconds), before = temperature_;
    temperature_ =
        !arrives ? rest + (temperature_ - rest) * std::exp(-seconds / time_constant) : target_;
    const double excess =
        ((power - drain) * way - capacity_ * (temperature_ - before)) / conductance;
    if (!arrives) return {power * seconds, excess, power};
    const HeatDraw after = advance(seconds - arrival, conductance, load);
    return {power * way + after.energy, excess + after.excess, std::max(power, after.peak)};
}

}  // namespace bead
