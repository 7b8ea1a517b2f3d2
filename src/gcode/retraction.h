// Retraction by the firmware (G10, G11): by how much and how fast, until M207, M208 or
// SET_RETRACTION say otherwise.
#pragma once
#include <string_view>

#include "gcode/dialect.h"
#include "gcode/scanner.h"

namespace bead {

struct Retraction {
    double length = 3, lift = 0;           // mm, of filament and of the head
    double extra = 0;                      // mm of filament that come back besides
    double speed = 45, recover_speed = 8;  // mm/s
};

// As the firmware's own sources have it: Klipper's retracts by nothing before it is told.
constexpr Retraction usual_retraction(Dialect dialect) {
    if (dialect != klipper_dialect) return {};
    return {.length = 0, .speed = 20, .recover_speed = 10};
}

// With what M207 names: S, Z, F, in RepRapFirmware also R (extra) and T (speed of return).
Retraction with_m207(Retraction retraction, const Words& words, Dialect dialect);
// With what M208 names: S (extra), F.
Retraction with_m208(Retraction retraction, const Words& words);
// With what SET_RETRACTION names.
Retraction with_klipper_words(Retraction retraction, std::string_view words);

}  // namespace bead
