// The published energy model of X and Y motors (D. K. Somade, thesis, Northern Illinois University
// 2023, Eqs. 24-28): energy = kA·A + kB·B + kC·C + kH·H of four features of the motion.
// Only for comparison with the publication: it charges standing still only to an axis that moves
// exactly nothing, so tilting lines by a degree seems to save 15 % (see `standing_form`).
#pragma once
#include "motion/block.h"

namespace bead {

// Features of the X and Y motion. With r = |delta_j| / length of the axis and per block:
struct Features {
    double A = 0;  // (mm/s)², sum over X of r² [(v_peak² - v_entry²) + (v_peak² - v_exit²)] / 2
    double B = 0;  // (mm/s)², the same over Y
    double C = 0;  // mm, sum over X and Y of r · v_peak · t_cruise: axis distance at constant speed
    double H =
        0;  // s, sum over X and Y of the time in which the axis does not move, dwells not included
    double axis_time = 0;  // s, of X plus of Y: twice the duration, dwells not included
};

Features features_of(const Block& block);

inline Features& operator+=(Features& a, const Features& b) {
    a.A += b.A;
    a.B += b.B;
    a.C += b.C;
    a.H += b.H;
    a.axis_time += b.axis_time;
    return a;
}
inline Features operator+(Features a, const Features& b) { return a += b; }

// Coefficients of Eq. 28 in J; the thesis prints mJ.
struct MotorCoefficients {
    double a = 0.134857071e-3, b = 0.131575661e-3;  // J per (mm/s)²
    double c = 69.14025683e-3;                      // J per mm
    double h = 0.8327358875;                        // W
};

double published_energy(const Features& features, const MotorCoefficients& k = {});  // J

// The same four numbers without the loophole, for searching: each axis draws its standing power kH
// all the time, and coasting costs on top of it what is left of kC at `usual_speed` u (mm/s, of an
// axis):
//     kC' = max(0, kC - kH / u),  so that  kH + kC'·u = kC·u: an axis that coasts at u costs as
//     published.
// It grows without a step as an axis begins to move, and slower means longer and therefore dearer.
// kA and kB stay, so accelerating costs kH times its time more than published (15 % at 1000 mm/s²).
double standing_form(const Features& features, const MotorCoefficients& k = {},
                     double usual_speed = 80);  // J

}  // namespace bead
