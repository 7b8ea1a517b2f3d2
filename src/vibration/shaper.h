// Input shapers: a command is replaced by a few delayed copies of itself whose vibrations cancel.
// ZV, ZVD (Singer, Seering 1990), EI and its two- and three-hump forms (Singhose 1994, 1997; here
// with Klipper's fitted constants for 5 % of vibration) and MZV, Klipper's compromise of length.
// The smoothing of a corner is the measure of Klipper's documentation.
#pragma once
#include <array>
#include <complex>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bead {

enum class ShaperKind : std::uint8_t { zv, mzv, zvd, ei, two_hump_ei, three_hump_ei };
inline constexpr std::array<std::string_view, 6> shaper_names{"zv", "mzv",      "zvd",
                                                              "ei", "2hump_ei", "3hump_ei"};

struct Pulse {
    double weight = 0;  // all of a shaper come to 1
    double delay = 0;   // s; the weighted mean is 0, so that X and Y stay together
};

// For a mode of a frequency (Hz, above 0) and damping ratio (0 <= ratio < 1).
std::vector<Pulse> shaper(ShaperKind kind, double frequency, double damping);

// What it makes of a sine of `omega` (rad/s).
std::complex<double> gain(const std::vector<Pulse>& pulses, double omega);

// Amplitude of vibration that it leaves behind of a mode, as a part of what there would be without.
double residual_vibration(const std::vector<Pulse>& pulses, double frequency, double damping);

// mm by which a right-angled corner is rounded: at the square corner velocity (mm/s), or where
// speed changes by half the acceleration (mm/s²), whichever is more.
double smoothing(const std::vector<Pulse>& pulses, double acceleration,
                 double square_corner_velocity);

}  // namespace bead
