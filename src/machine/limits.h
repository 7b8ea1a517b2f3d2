// What a machine can do: the numbers that its firmware plans with. Order of axes: X, Y, Z, E.
// The defaults are those of an i3-like desktop printer and serve as an example; real values come
// from a printer file.
#pragma once
#include <array>

namespace bead {

struct Limits {
    std::array<double, 4> steps_per_mm{100, 100, 400, 280};
    std::array<double, 4> max_feedrate{200, 200, 12, 120};          // mm/s
    std::array<double, 4> max_acceleration{1250, 1250, 200, 5000};  // mm/s²
    double acceleration = 1250;                                     // mm/s², moves that print
    double retract_acceleration = 1250;            // mm/s², moves of the filament alone
    double travel_acceleration = 1250;             // mm/s², moves without filament
    std::array<double, 4> jerk{10, 10, 0.4, 2.5};  // mm/s, speed step allowed at a corner

    // Of other firmware; kept with the rest so that a printer file is one thing.
    double junction_deviation = 0.013;  // mm (Marlin)
    double square_corner_velocity = 5;  // mm/s (Klipper, as all below)
    double minimum_cruise_ratio = 0.5;
    double extrude_only_velocity = 120;          // mm/s
    double extrude_only_acceleration = 1250;     // mm/s²
    double instantaneous_corner_velocity = 2.5;  // mm/s
    double arc_resolution = 1.0;                 // mm
    double path_jerk = 100'000;                  // mm/s³, of planners that limit it (s-curve)
    int drop_segments = 5;  // steps; a move of no more on every axis joins the next one
    bool slowdown = false;  // short moves are stretched while the queue runs dry
};

}  // namespace bead
