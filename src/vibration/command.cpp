#include "vibration/command.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/expects.h"
#include "vibration/drive.h"

namespace bead {
namespace {

// The bell's deviation times the first mode's ω. By itself feed-forward also has to keep the mode
// from ringing, so that the bell lets 0.88 of it through; behind a shaper only slow lag is left.
constexpr double bell = 0.5, bell_behind_shaper = 1.2;

// What is left of a deviation of σ, in samples, behind two boxes of n samples each, which deviate
// by (n² - 1)/12: twice a box of 2 m + 1 samples with a share of those beyond its ends.
CommandFilter::Box rest_of(double sigma, std::size_t n) {
    const double pair = (double(n * n) - 1) / 6, rest = (sigma * sigma - pair) / 2;
    const double m = std::floor((std::sqrt(1 + 12 * rest) - 1) / 2), whole = 2 * m + 1;
    const double ends = whole * (rest - m * (m + 1) / 3) / (2 * ((m + 1) * (m + 1) - rest));
    return {std::size_t(m), ends, 1 / (whole + 2 * ends)};
}

// The mean over a box about every sample that has one whole.
std::vector<double> boxed(const std::vector<double>& values, const CommandFilter::Box& box) {
    const std::size_t whole = 2 * box.half + 1;
    std::vector<double> means(values.size() - whole - 1);
    double sum = 0;
    for (std::size_t i = 0; i < whole; ++i) sum += values[i];
    for (std::size_t i = 0; i < means.size(); ++i) {
        sum += values[i + whole] - values[i];
        means[i] = box.weight * (sum + box.ends * (values[i] + values[i + whole + 1]));
    }
    return means;
}

std::vector<Pulse> pulses_of(const DriveMode& mode, const TimeLaw& law) {
    if (!law.shaper) return {{1, 0}};
    return shaper(*law.shaper, mode.frequency, mode.damping);
}

// The gain where the machine only lags, at 1 Hz; a detuned model has its lag at another frequency.
double lead_of(const DriveAxis& axis, const std::vector<Pulse>& pulses, double tuning) {
    const double omega = 2 * std::numbers::pi;
    const double drive_gain = std::abs(gain(drive(axis), omega / tuning));
    return (std::abs(gain(pulses, omega)) * drive_gain - 1) / (omega * omega);
}

}  // namespace

CommandFilter::CommandFilter(const DriveAxis& axis, const TimeLaw& law, double step) {
    BEAD_EXPECTS(step > 0 && law.tuning > 0);
    DriveMode mode = first_mode(axis);
    mode.frequency *= law.tuning;
    const std::vector<Pulse> pulses = pulses_of(mode, law);
    for (const Pulse& pulse : pulses) {
        const double place = -pulse.delay / step, low = std::floor(place);
        taps_.push_back({std::ptrdiff_t(low), pulse.weight * (low + 1 - place)});
        if (place > low) taps_.push_back({std::ptrdiff_t(low) + 1, pulse.weight * (place - low)});
    }
    for (const Tap& tap : taps_) reach_ = std::max(reach_, std::size_t(std::abs(tap.offset)));
    margin_ = reach_;
    lead_ = lead_of(axis, pulses, law.tuning);
    if (!law.feed_forward) return;
    bound_ = std::abs(lead_) * law.acceleration;
    const double omega = 2 * std::numbers::pi * mode.frequency;
    const double sigma = (law.shaper ? bell_behind_shaper : bell) / (omega * step);
    pair_ = std::size_t(std::sqrt(3 * sigma * sigma + 1));
    box_ = rest_of(sigma, pair_);
    margin_ += pair_ + 2 * (box_.half + 1);
    const double width = double(pair_) * step;
    scale_ = 1 / (width * width);
}

// Two of the four boxes and both derivatives are one second difference of that width; so the cost
// does not depend on the width.
std::vector<double> CommandFilter::led(std::span<const double> samples) const {
    const std::size_t n = pair_;
    std::vector<double> bend(samples.size() - 2 * n);
    for (std::size_t i = 0; i < bend.size(); ++i)
        bend[i] = scale_ * (samples[i + 2 * n] - 2 * samples[i + n] + samples[i]);
    bend = boxed(boxed(bend, box_), box_);
    const std::size_t lost = (samples.size() - bend.size()) / 2;
    for (std::size_t i = 0; i < bend.size(); ++i)
        bend[i] = samples[i + lost] + std::clamp(lead_ * bend[i], -bound_, bound_);
    return bend;
}

void CommandFilter::filter(std::span<const double> samples, std::vector<double>& out) const {
    BEAD_EXPECTS(samples.size() > 2 * margin_);
    const bool leads = pair_ > 0;
    const std::vector<double> leading = leads ? led(samples) : std::vector<double>();
    const std::span<const double> plain = leads ? std::span<const double>(leading) : samples;
    const std::size_t lost = (plain.size() - (samples.size() - 2 * margin_)) / 2;
    out.assign(samples.size() - 2 * margin_, 0);
    for (const Tap& tap : taps_) {
        const double* const from = plain.data() + std::ptrdiff_t(lost) + tap.offset;
        for (std::size_t i = 0; i < out.size(); ++i) out[i] += tap.weight * from[i];
    }
}

}  // namespace bead
