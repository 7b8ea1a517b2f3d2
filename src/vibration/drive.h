// One axis as six masses on springs: q = [x1 x2 x3 x4 θM θS], both screws' axial motion, the slave
// pedestal at the nut, the table with the nozzle, the motor, the screw. Lagrange's equations of
//     nut  e = x3 - (x1 + x2)/2 - i·θS,   flexure  f = x4 - x3,   i = lead/2π
// give M q'' + C q' + K q = F; the servo closes the loop about the motor's angle. SI units.
// After the lumped model of vibration-suppressed toolpaths, its contradictions resolved
// (docs/vibration.md).
#pragma once
#include <array>
#include <complex>
#include <vector>

#include "machine/vibration.h"
#include "numeric/linear_modes.h"

namespace bead {

inline constexpr std::size_t drive_order = 6;
using DriveMatrix = std::array<std::array<double, drive_order>, drive_order>;

struct Drive {
    std::array<double, drive_order> mass{};  // kg, kg m²
    DriveMatrix damping{}, stiffness{};      // free, without servo
    double ratio = 0;                        // m/rad, i
    double kp = 0, kd = 0,
           inertia = 0;  // servo: τ = kp(θref - θM) + kd(θref' - θM') + inertia·θref''
};

// `nut_distance` (m): from the coupling to the nut.
Drive drive(const DriveAxis& axis, double nut_distance);
inline Drive drive(const DriveAxis& axis) { return drive(axis, axis.screw.nut_distance); }

// The closed loop as x' = A·x + b·u with x = [q, q'] and the one input
// u = kp·θref + kd·θref' + inertia·θref''.
struct ClosedLoop {
    std::vector<double> matrix;  // 12 × 12, by rows
    std::vector<double> input;   // 12
};
ClosedLoop closed_loop(const Drive& drive);

// Table / command for a sine of omega (rad/s).
std::complex<double> gain(const Drive& drive, double omega);

struct DriveMode {
    double frequency = 0;  // Hz
    double damping = 0;    // ratio
};
// Of the closed loop, those that swing, lowest first.
std::vector<DriveMode> drive_modes(const Drive& drive);
// The lowest one that rings, which is the one to shape for: damped by less than half.
DriveMode first_mode(const DriveAxis& axis);

// The axis with its flexure so that the first mode of the closed loop is the measured one; the
// servo is made stiff enough not to be part of it. Expects 0 < frequency, 0 <= damping < 0.5.
DriveAxis with_mode(DriveAxis axis, const DriveMode& measured);

}  // namespace bead
