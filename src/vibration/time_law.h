// In what time a path is driven: apart from the path, so that either can be judged by itself.
//
//     K0    speeds as trapezoids, corners by square corner velocity (Klipper, Marlin alike)
//     K1    jerk limited too; smooth bends by centripetal acceleration, steps of velocity bounded
//     f     feed-forward: the command leads by what the machine will lag, c2·p''
//     K2, M shaped commands on top of K0 or K1, MZV unless another is asked for
#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "vibration/shaper.h"

namespace bead {

enum class SpeedProfile : std::uint8_t { trapezoid, jerk_limited };
inline constexpr std::array<std::string_view, 2> profile_names{"trapezoid", "jerk-limited"};

struct TimeLaw {
    SpeedProfile profile = SpeedProfile::trapezoid;
    double acceleration = 1000;         // mm/s², along the path and across it
    double jerk = 20'000;               // mm/s³, along the path; jerk_limited only
    double square_corner_velocity = 5;  // mm/s
    double velocity_step = 12;          // mm/s, most at any point; jerk_limited only
    double feed_factor = 1;             // all feeds of the path times this
    std::optional<ShaperKind> shaper{};
    double tuning = 1;  // what shaper and feed-forward take the modes for / what they are
    bool feed_forward = false;
};

struct NamedLaw {
    std::string_view name;
    TimeLaw law;
};
inline constexpr std::array named_laws{
    NamedLaw{"K0", {}},
    NamedLaw{"K1", {.profile = SpeedProfile::jerk_limited}},
    NamedLaw{"K1f", {.profile = SpeedProfile::jerk_limited, .feed_forward = true}},
    NamedLaw{"K2", {.shaper = ShaperKind::mzv}},
    NamedLaw{"K2f", {.shaper = ShaperKind::mzv, .feed_forward = true}},
    NamedLaw{"K1M", {.profile = SpeedProfile::jerk_limited, .shaper = ShaperKind::mzv}},
    NamedLaw{
        "K1Mf",
        {.profile = SpeedProfile::jerk_limited, .shaper = ShaperKind::mzv, .feed_forward = true}}};

}  // namespace bead
