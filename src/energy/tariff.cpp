#include "energy/tariff.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/expects.h"

namespace bead {

namespace {

constexpr double time_rounding = 1e-6;  // s: what is closer to a change is after it

bool covers_the_day(const Tariff& tariff) {
    double end = 0;
    for (const Rate& rate : tariff) {
        if (rate.from != end || rate.to <= rate.from) return false;
        end = rate.to;
    }
    return end == day;
}

}  // namespace

Billing::Billing(Tariff tariff, double start) : tariff_(std::move(tariff)), start_(start) {
    BEAD_EXPECTS(covers_the_day(tariff_));
    bill_.energy.resize(tariff_.size());
}

double Billing::time_of_day(double time) const {
    return std::fmod(start_ + time + time_rounding, day);
}

std::size_t Billing::rate_at(double time) const {
    const double now = time_of_day(time);
    const auto rate = std::ranges::find_if(tariff_, [&](const Rate& r) { return now < r.to; });
    return static_cast<std::size_t>(rate - tariff_.begin());
}

double Billing::next_change(double time) const {
    return time + time_rounding + tariff_[rate_at(time)].to - time_of_day(time);
}

void Billing::add(const PowerPiece& piece) {
    const std::size_t rate = rate_at(piece.time);
    const double joules = total(piece.energy);
    bill_.energy[rate] += joules;
    (piece.heating ? bill_.heat_up : bill_.print) += tariff_[rate].price * joules / joules_per_kwh;
}

}  // namespace bead
