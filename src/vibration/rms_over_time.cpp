#include "vibration/rms_over_time.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"

namespace bead {

RmsOverTime::RmsOverTime(double step, std::size_t most) : step_(step), most_(most) {
    BEAD_EXPECTS(step > 0 && most >= 2);
}

void RmsOverTime::add(Vec2 acceleration) {
    if (count_ == most_ * per_window_) halve();
    if (count_ % per_window_ == 0) sums_.push_back(0);
    sums_.back() += dot(acceleration, acceleration);
    ++count_;
}

void RmsOverTime::halve() {
    std::vector<double> half;
    half.reserve(most_);
    for (std::size_t i = 0; i < sums_.size(); i += 2)
        half.push_back(sums_[i] + (i + 1 < sums_.size() ? sums_[i + 1] : 0));
    sums_ = std::move(half);
    per_window_ *= 2;
}

std::vector<RmsWindow> RmsOverTime::windows() const {
    std::vector<RmsWindow> result;
    result.reserve(sums_.size());
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const std::size_t first = i * per_window_, last = std::min(count_, first + per_window_);
        result.push_back({step_ * double(first), step_ * double(last),
                          std::sqrt(sums_[i] / double(last - first))});
    }
    return result;
}

}  // namespace bead
