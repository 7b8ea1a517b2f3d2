// Whose rules the text is read by, where firmwares differ: a bit each, so that a command can name
// all that obey it.
#pragma once
#include <cstdint>
#include <string_view>

#include "machine/firmware.h"

namespace bead {

enum Dialect : std::uint8_t {
    prusa_dialect = 1,
    prusa_2017_dialect = 2,
    marlin_dialect = 4,
    klipper_dialect = 8,
    reprap_dialect = 16,  // RepRapFirmware, which no planner here imitates: the text tells it
};
inline constexpr unsigned every_dialect = 31;

constexpr Dialect dialect_of(Firmware firmware) {
    switch (firmware) {
        case Firmware::prusa:
            return prusa_dialect;
        case Firmware::prusa_2017:
            return prusa_2017_dialect;
        case Firmware::klipper:
            return klipper_dialect;
        default:
            return marlin_dialect;
    }
}

constexpr std::string_view name_of(Dialect dialect) {
    switch (dialect) {
        case prusa_dialect:
            return "prusa";
        case prusa_2017_dialect:
            return "prusa-2017";
        case klipper_dialect:
            return "klipper";
        case reprap_dialect:
            return "RepRapFirmware";
        default:
            return "marlin";
    }
}

// What G90 and G91 do to the extruder, which M82 and M83 switch in any case.
enum class ExtruderMode : std::uint8_t {
    untouched,  // nothing
    either,     // it is relative after G91 or M83, whichever stands
    last_said,  // they switch it as well; the last command counts
};
constexpr ExtruderMode extruder_mode(Dialect dialect) {
    switch (dialect) {
        case prusa_2017_dialect:
        case klipper_dialect:
            return ExtruderMode::either;
        case marlin_dialect:
            return ExtruderMode::last_said;
        default:
            return ExtruderMode::untouched;
    }
}

}  // namespace bead
