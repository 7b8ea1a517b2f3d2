// A mode from a measured spectrum, such as Klipper writes when it shakes an axis: the base is
// driven with the same acceleration at every frequency, so the power seen is that of one mass on a
// spring,
//     P(f) ~ (1 + (2ζr)²) / ((1 - r²)² + (2ζr)²),   r = f/f0,
// whose inverse is a parabola in f² near the highest peak: a linear fit.
#pragma once
#include <optional>
#include <span>

#include "vibration/drive.h"

namespace bead {

// `frequency` (Hz) grows. Nothing if the highest peak is at an end, or no mode has its shape.
std::optional<DriveMode> fitted_mode(std::span<const double> frequency,
                                     std::span<const double> power);

}  // namespace bead
