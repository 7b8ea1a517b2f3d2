#include "energy/power_curve.h"

#include <cmath>
#include <utility>

#include "core/expects.h"

namespace bead {

namespace {

// Of a step: times that are closer than this to its end are its end, whatever rounding made of
// them.
constexpr double rounding_share = 1e-6;

}  // namespace

PowerCurve::PowerCurve(double step, std::function<void(const PowerStep&)> sink)
    : step_(step), sink_(std::move(sink)) {
    BEAD_EXPECTS(step > 0);
}

double PowerCurve::index(double time) const { return std::floor(time / step_ + rounding_share); }

double PowerCurve::end_of_step(double time) const { return (index(time) + 1) * step_; }

void PowerCurve::add(const PowerPiece& piece) {
    tell_until(index(piece.time));
    sum_ += piece.energy;
    begun_ = true;
}

void PowerCurve::tell_until(double index) {
    for (; now_ < index; ++now_) sink_({now_ * step_, (1 / step_) * std::exchange(sum_, {})});
}

void PowerCurve::finish() {
    if (std::exchange(begun_, false)) tell_until(now_ + 1);
}

}  // namespace bead
