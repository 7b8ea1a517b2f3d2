// One straight move at constant acceleration: speed up, hold, slow down.
// Closed form; spec of the firmware and of Eqs. 9-15 of Somade (2023), corrected: both ramps count
// for the distance, and a move too short to reach its nominal speed peaks below it.
#pragma once

namespace bead {

struct Trapezoid {
    double v_entry = 0, v_peak = 0, v_exit = 0;     // mm/s
    double t_accel = 0, t_cruise = 0, t_decel = 0;  // s
};

// Over `length` (mm) from v_entry to v_exit, no faster than v_nominal, at `acceleration` (mm/s²).
// Entry and exit above v_nominal are cut to it. An exit that cannot be reached becomes the nearest
// speed that can: the distance always comes out right.
Trapezoid trapezoid(double length, double v_nominal, double v_entry, double v_exit,
                    double acceleration);

// The same for who has the squares of both speeds, (mm/s)²: it saves roots.
Trapezoid trapezoid_of_squares(double length, double v_nominal, double entry2, double exit2,
                               double acceleration);

}  // namespace bead
