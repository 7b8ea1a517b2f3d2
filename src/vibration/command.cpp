#include "vibration/command.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/expects.h"
#include "vibration/drive.h"

namespace bead {
namespace {

// Odd, so that the box lies about its sample: four in a row deviate by σ = √(4 (n² - 1)/12).
std::size_t box_samples(double deviation, double step) {
    const double sigma = deviation / step;
    const double n = std::sqrt(3 * sigma * sigma + 1);
    return 2 * std::size_t(std::lround((n - 1) / 2)) + 1;
}

// The mean over a box about every sample that has one whole.
std::vector<double> boxed(const std::vector<double>& values, std::size_t box) {
    std::vector<double> means(values.size() - box + 1);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += values[i];
        if (i + 1 < box) continue;
        means[i + 1 - box] = sum / double(box);
        sum -= values[i + 1 - box];
    }
    return means;
}

std::vector<Pulse> pulses_of(const DriveAxis& axis, const TimeLaw& law) {
    if (!law.shaper) return {{1, 0}};
    const DriveMode mode = first_mode(axis);
    return shaper(*law.shaper, mode.frequency * law.tuning, mode.damping);
}

// The gain where the machine only lags, at 1 Hz; a detuned model has its lag at another frequency.
double lead_of(const DriveAxis& axis, const std::vector<Pulse>& pulses, double tuning) {
    const double omega = 2 * std::numbers::pi;
    const double drive_gain = std::abs(gain(drive(axis), omega / tuning));
    return (std::abs(gain(pulses, omega)) * drive_gain - 1) / (omega * omega);
}

}  // namespace

CommandFilter::CommandFilter(const DriveAxis& axis, const TimeLaw& law, double step)
    : bound_(law.feed_forward_bound) {
    BEAD_EXPECTS(step > 0 && law.tuning > 0);
    const std::vector<Pulse> pulses = pulses_of(axis, law);
    for (const Pulse& pulse : pulses) {
        const double place = -pulse.delay / step, low = std::floor(place);
        taps_.push_back({std::ptrdiff_t(low), pulse.weight * (low + 1 - place)});
        if (place > low) taps_.push_back({std::ptrdiff_t(low) + 1, pulse.weight * (place - low)});
    }
    for (const Tap& tap : taps_) reach_ = std::max(reach_, std::size_t(std::abs(tap.offset)));
    margin_ = reach_;
    lead_ = lead_of(axis, pulses, law.tuning);
    if (!law.feed_forward) return;
    box_ = box_samples(law.feed_forward_smoothing, step);
    margin_ += 2 * box_;
    scale_ = 1 / (double(box_) * step) / (double(box_) * step);
}

// Two of the four boxes and both derivatives are one second difference of that width; so the cost
// does not depend on the width.
std::vector<double> CommandFilter::led(std::span<const double> samples) const {
    const std::size_t n = box_;
    std::vector<double> bend(samples.size() - 2 * n);
    for (std::size_t i = 0; i < bend.size(); ++i)
        bend[i] = scale_ * (samples[i + 2 * n] - 2 * samples[i + n] + samples[i]);
    bend = boxed(boxed(bend, n), n);
    const std::size_t lost = (samples.size() - bend.size()) / 2;
    for (std::size_t i = 0; i < bend.size(); ++i)
        bend[i] = samples[i + lost] + std::clamp(lead_ * bend[i], -bound_, bound_);
    return bend;
}

void CommandFilter::filter(std::span<const double> samples, std::vector<double>& out) const {
    BEAD_EXPECTS(samples.size() > 2 * margin_);
    const std::vector<double> leading = box_ > 0 ? led(samples) : std::vector<double>();
    const std::span<const double> plain = box_ > 0 ? std::span<const double>(leading) : samples;
    const std::size_t lost = (plain.size() - (samples.size() - 2 * margin_)) / 2;
    out.assign(samples.size() - 2 * margin_, 0);
    for (const Tap& tap : taps_) {
        const double* const from = plain.data() + std::ptrdiff_t(lost) + tap.offset;
        for (std::size_t i = 0; i < out.size(); ++i) out[i] += tap.weight * from[i];
    }
}

}  // namespace bead
