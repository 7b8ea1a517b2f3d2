#include "vibration/shaking.h"

#include <algorithm>
#include <cmath>

#include "core/expects.h"

namespace bead {
namespace {

std::size_t ratio_of(double step) {
    const double ratio = 1 / (spectrum_rate * step);
    BEAD_EXPECTS(std::abs(ratio - std::round(ratio)) < 1e-6 && ratio > 0.5);
    return std::size_t(std::lround(ratio));
}

// Bins of the spectrum within the band.
struct Band {
    std::size_t first = 0, last = 0;
};
Band band_of(const Spectrum& spectrum) {
    const auto first = std::size_t(std::ceil(band_low / spectrum.step - 1e-9));
    const auto last = std::size_t(std::floor(band_high / spectrum.step + 1e-9));
    return {first, std::min(last, spectrum.density.size() - 1)};
}

void report_band(Response& response) {
    const Spectrum& spectrum = response.spectrum;
    const Band band = band_of(spectrum);
    if (band.first > band.last) return;
    std::vector<double> values(spectrum.density.begin() + std::ptrdiff_t(band.first),
                               spectrum.density.begin() + std::ptrdiff_t(band.last) + 1);
    double area = 0;
    for (std::size_t k = 0; k + 1 < values.size(); ++k)
        area += spectrum.step * (values[k] + values[k + 1]) / 2;
    response.rms_5_40hz = std::sqrt(area);
    const auto peak = std::ranges::max_element(values);
    response.peak_frequency =
        spectrum.step * double(band.first + std::size_t(peak - values.begin()));
    std::ranges::sort(values, std::greater<>());
    const std::size_t top = std::min<std::size_t>(3, values.size());
    for (std::size_t k = 0; k < top; ++k) response.psd_top3 += values[k] / double(top);
}

}  // namespace

Shaking::Shaking(double step) : decimator_(ratio_of(step)) {}

void Shaking::add(Vec2 acceleration) {
    sum_ += dot(acceleration, acceleration);
    ++count_;
    if (decimator_.add({acceleration.x, acceleration.y})) welch_.add(decimator_.value());
}

void Shaking::report(Response& response) {
    if (count_ == 0) return;
    response.rms_acceleration = std::sqrt(sum_ / double(count_));
    for (std::size_t i = 0; i < decimator_.delay(); ++i)
        if (decimator_.add(0)) welch_.add(decimator_.value());
    const Welch::Density density = welch_.density();
    if (density.segments == 0) return;
    response.spectrum.step = spectrum_rate / double(density.length);
    for (const double power : density.power)
        response.spectrum.density.push_back(power / spectrum_rate);
    report_band(response);
}

}  // namespace bead
