// Whose rules a machine moves by. G-code means slightly different things to each, and each plans
// motion in its own way.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace bead {

enum class Firmware : std::uint8_t {
    prusa,        // Prusa-Firmware of 2023 (8 bit)
    prusa_2017,   // the same of March 2017
    marlin_jerk,  // Marlin 2.1 with classic jerk
    marlin_jd,    // Marlin 2.1 with junction deviation
    klipper,
    s_curve,  // none of them: a planner of our own that limits jerk, with Marlin's reading
};

// As users name them, in the order above.
inline constexpr std::array<std::string_view, 6> firmware_names{
    "prusa", "prusa-2017", "marlin-jerk", "marlin-jd", "klipper", "s-curve"};

constexpr std::string_view name_of(Firmware firmware) {
    return firmware_names[std::size_t(firmware)];
}

}  // namespace bead
