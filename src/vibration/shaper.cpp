#include "vibration/shaper.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/expects.h"

namespace bead {
namespace {

struct Mode {
    double period;  // s, of the damped swing
    double decay;   // what is left of a swing after half of it
};

using Pulses = std::vector<Pulse>;

Pulses zv(const Mode& m) { return {{1, 0}, {m.decay, 0.5 * m.period}}; }

Pulses zvd(const Mode& m) {
    return {{1, 0}, {2 * m.decay, 0.5 * m.period}, {m.decay * m.decay, m.period}};
}

// Three pulses at 3/8 of a period: shorter than ZVD, more tolerant than ZV.
Pulses mzv(const Mode& m) {
    const double decay = std::pow(m.decay, 0.75);
    const double first = 1 - 1 / std::numbers::sqrt2;
    return {{first, 0},
            {(std::numbers::sqrt2 - 1) * decay, 0.375 * m.period},
            {first * decay * decay, 0.75 * m.period}};
}

constexpr double tolerance = 0.05;  // of vibration left where it is most, of the EI family

Pulses ei(const Mode& m) {
    const double outer = 0.25 * (1 + tolerance), inner = 0.5 * (1 - tolerance);
    return {{outer, 0}, {inner * m.decay, 0.5 * m.period}, {outer * m.decay * m.decay, m.period}};
}

Pulses two_hump_ei(const Mode& m) {
    const double v2 = tolerance * tolerance;
    const double x = std::cbrt(v2 * (std::sqrt(1 - v2) + 1));
    const double first = (3 * x * x + 2 * x + 3 * v2) / (16 * x);
    const double second = (0.5 - first) * m.decay;
    return {{first, 0},
            {second, 0.5 * m.period},
            {second * m.decay, m.period},
            {first * std::pow(m.decay, 3), 1.5 * m.period}};
}

Pulses three_hump_ei(const Mode& m) {
    const double v = tolerance, k = m.decay;
    const double first = 0.0625 * (1 + 3 * v + 2 * std::sqrt(2 * (v + 1) * v));
    const double second = 0.25 * (1 - v) * k;
    const double third = (0.5 * (1 + v) - 2 * first) * k * k;
    return {{first, 0},
            {second, 0.5 * m.period},
            {third, m.period},
            {second * k * k, 1.5 * m.period},
            {first * std::pow(k, 4), 2 * m.period}};
}

struct NamedShaper {
    ShaperKind kind;
    Pulses (*make)(const Mode&);
};
constexpr std::array named_shapers{NamedShaper{ShaperKind::zv, zv},
                                   NamedShaper{ShaperKind::mzv, mzv},
                                   NamedShaper{ShaperKind::zvd, zvd},
                                   NamedShaper{ShaperKind::ei, ei},
                                   NamedShaper{ShaperKind::two_hump_ei, two_hump_ei},
                                   NamedShaper{ShaperKind::three_hump_ei, three_hump_ei}};

void normalise(Pulses& pulses) {
    double sum = 0, moment = 0;
    for (const Pulse& pulse : pulses) {
        sum += pulse.weight;
        moment += pulse.weight * pulse.delay;
    }
    for (Pulse& pulse : pulses) {
        pulse.weight /= sum;
        pulse.delay -= moment / sum;
    }
}

}  // namespace

std::vector<Pulse> shaper(ShaperKind kind, double frequency, double damping) {
    BEAD_EXPECTS(frequency > 0 && damping >= 0 && damping < 1);
    const double root = std::sqrt(1 - damping * damping);
    const Mode mode{1 / (frequency * root), std::exp(-damping * std::numbers::pi / root)};
    Pulses pulses = std::ranges::find(named_shapers, kind, &NamedShaper::kind)->make(mode);
    normalise(pulses);
    return pulses;
}

std::complex<double> gain(const std::vector<Pulse>& pulses, double omega) {
    std::complex<double> sum;
    for (const Pulse& pulse : pulses) sum += pulse.weight * std::polar(1.0, -omega * pulse.delay);
    return sum;
}

double residual_vibration(const std::vector<Pulse>& pulses, double frequency, double damping) {
    const double omega = 2 * std::numbers::pi * frequency, root = std::sqrt(1 - damping * damping);
    std::complex<double> sum;
    const double last = pulses.back().delay;
    for (const Pulse& pulse : pulses)
        sum += pulse.weight * std::exp(-damping * omega * (last - pulse.delay)) *
               std::polar(1.0, omega * root * pulse.delay);
    return std::abs(sum);
}

double smoothing(const std::vector<Pulse>& pulses, double acceleration,
                 double square_corner_velocity) {
    double turn = 0, change = 0;  // of the velocity: by 90°, and back by 180°
    for (const Pulse& pulse : pulses) {
        const double t = pulse.delay;
        const double way = (square_corner_velocity + acceleration * std::abs(t) / 2) * std::abs(t);
        if (t > 0) turn += pulse.weight * way;
        change += pulse.weight * acceleration / 2 * t * t;
    }
    return std::max(turn * std::numbers::sqrt2, change);
}

}  // namespace bead
