#include "numeric/decimate.h"

#include <cmath>
#include <numbers>

#include "core/expects.h"

namespace bead {
namespace {

// Halves of the band edge's power at the new Nyquist frequency; gain 1 at rest.
std::vector<double> low_pass(std::size_t ratio) {
    if (ratio == 1) return {1};
    const auto half = std::ptrdiff_t(10 * ratio);
    std::vector<double> taps;
    double sum = 0;
    for (std::ptrdiff_t k = -half; k <= half; ++k) {
        const double x = std::numbers::pi * double(k) / double(ratio);
        const double window = 0.54 + 0.46 * std::cos(std::numbers::pi * double(k) / double(half));
        taps.push_back(window * (k == 0 ? 1 : std::sin(x) / x));
        sum += taps.back();
    }
    for (double& tap : taps) tap /= sum;
    return taps;
}

}  // namespace

Decimator::Decimator(std::size_t ratio)
    : ratio_(ratio), taps_(low_pass(ratio)), ring_(2 * taps_.size()) {
    BEAD_EXPECTS(ratio > 0);
}

bool Decimator::add(std::complex<double> value) {
    const std::size_t place = seen_ % taps_.size();
    ring_[place] = ring_[place + taps_.size()] = value;
    ++seen_;
    return seen_ > delay() && (seen_ - 1 - delay()) % ratio_ == 0;
}

// Taps are the same both ways from the middle; two sums at a time keep the processor busy.
std::complex<double> Decimator::value() const {
    const std::complex<double>* const oldest = ring_.data() + seen_ % taps_.size();
    const std::complex<double>* const newest = oldest + taps_.size() - 1;
    const std::size_t half = taps_.size() / 2;
    std::complex<double> even = taps_[half] * oldest[half], odd;
    std::size_t k = 0;
    for (; k + 1 < half; k += 2) {
        even += taps_[k] * (oldest[k] + *(newest - k));
        odd += taps_[k + 1] * (oldest[k + 1] + *(newest - k - 1));
    }
    if (k < half) even += taps_[k] * (oldest[k] + *(newest - k));
    return even + odd;
}

}  // namespace bead
