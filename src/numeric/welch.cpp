#include "numeric/welch.h"

#include <kissfft/kissfft.hh>

#include <cmath>
#include <numbers>
#include <numeric>

#include "core/expects.h"

namespace bead {
namespace {

using Signal = std::vector<std::complex<double>>;

std::vector<double> hamming(std::size_t n) {
    std::vector<double> window(n);
    for (std::size_t i = 0; i < n; ++i)
        window[i] = 0.54 - 0.46 * std::cos(2 * std::numbers::pi * double(i) / double(n));
    return window;
}

// One-sided, both components.
std::vector<double> power_of(Signal segment) {
    const std::size_t n = segment.size();
    const std::vector<double> window = hamming(n);
    const std::complex<double> mean =
        std::accumulate(segment.begin(), segment.end(), std::complex<double>{}) / double(n);
    for (std::size_t i = 0; i < n; ++i) segment[i] = window[i] * (segment[i] - mean);
    Signal bins(n);
    kissfft<double>(n, false).transform(segment.data(), bins.data());

    const double scale = 1 / std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
    std::vector<double> power(n / 2 + 1);
    for (std::size_t k = 0; k < power.size(); ++k) {
        power[k] = scale * std::norm(bins[k]);
        if (k > 0 && 2 * k != n) power[k] += scale * std::norm(bins[n - k]);
    }
    return power;
}

}  // namespace

Welch::Welch(std::size_t segment) : length_(segment), sum_(segment / 2 + 1) {
    BEAD_EXPECTS(segment >= 2 && segment % 2 == 0);
    pending_.reserve(segment);
}

void Welch::add(std::complex<double> value) {
    pending_.push_back(value);
    if (pending_.size() < length_) return;
    const std::vector<double> power = power_of(pending_);
    for (std::size_t k = 0; k < power.size(); ++k) sum_[k] += power[k];
    ++segments_;
    pending_.erase(pending_.begin(), pending_.begin() + std::ptrdiff_t(length_ / 2));
}

Welch::Density Welch::density() const {
    if (segments_ == 0) {
        if (pending_.size() < 2) return {};
        return {1, pending_.size(), power_of(pending_)};
    }
    Density density{segments_, length_, sum_};
    for (double& power : density.power) power /= double(segments_);
    return density;
}

}  // namespace bead
