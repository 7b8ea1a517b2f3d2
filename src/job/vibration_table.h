// [vibration] of a PRINTER.toml: measured modes, or masses and stiffnesses, or both (then the
// flexure is what is fitted to the mode). Arrays hold X, Y. docs/vibration.md lists the keys.
#pragma once
#include "job/toml_reader.h"
#include "machine/vibration.h"

namespace bead {

inline constexpr double highest_mode = 100;  // Hz: acceleration is looked at 200 times a second

// What is not said is as in `base`; but a file that says anything of an axis says all of it, on top
// of the example machine: no desktop printer's modes under a portal's masses. Throws Error for a
// mode of 0 or beyond what is looked at, for negative damping, for a nut beyond its screw.
VibrationModel read_vibration(TomlReader& file, const VibrationModel& base);

}  // namespace bead
