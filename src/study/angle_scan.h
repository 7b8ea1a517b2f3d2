// The square of the experiment at other angles and speeds: what each model says of them. Shows what
// the published model gets wrong (a line tilted by one degree) and on what its advice depends.
#pragma once
#include "study/experiment.h"

namespace bead {

// J; the first two are of the X and Y motors.
struct ModelEnergies {
    double published = 0, standing = 0;
    double xy_motors = 0;  // the physics model, at the wall
    double machine = 0;    // all of it, heating up left out
    double duration = 0;   // s
};
// `machine` gives what is drawn; its limits are those of the experiment.
ModelEnergies model_energies(const ExperimentSetup& setup, const Machine& machine);

// Rectilinear at 0°, 1° … 90°.
std::vector<ModelEnergies> angle_scan(const Machine& machine, int threads = 0);

struct SpeedPoint {
    double speed = 0;                  // mm/s, of everything printed
    ModelEnergies straight, diagonal;  // infill at 0° and 45°
};
std::vector<SpeedPoint> speed_scan(std::span<const double> speeds, const Machine& machine,
                                   int threads = 0);

// mm/s below which a coasting diagonal costs less than a straight line, by the coefficients alone:
// √2 = 1 + kH / (kC v).
double break_even_speed(const MotorCoefficients& k = {});

}  // namespace bead
