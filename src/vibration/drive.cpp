#include "vibration/drive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/expects.h"

namespace bead {
namespace {

using Elongation = std::array<double, drive_order>;  // of a spring, per unit of each coordinate

constexpr std::size_t motor = 4, screw_turn = 5;
constexpr double ringing = 0.5;  // damping ratio below which a mode is felt as one

double in_series(double a, double b) { return a * b / (a + b); }
double damper(double ratio, double stiffness, double mass) {
    return 2 * ratio * std::sqrt(stiffness * mass);
}

double screw_stiffness(const Screw& s, double nut_distance) {
    const double one_side = std::numbers::pi * s.radius * s.radius * s.young / nut_distance;
    if (s.support == ScrewSupport::fixed_free) return one_side;
    return one_side * s.length / (s.length - nut_distance);
}

double twist_stiffness(const Screw& s, double nut_distance) {
    return std::numbers::pi * s.shear * std::pow(s.radius, 4) / (2 * nut_distance);
}

double screw_mass(const Screw& s) {
    return std::numbers::pi * s.density * s.length * s.radius * s.radius + s.rotor_mass +
           s.coupling_mass;
}

double screw_inertia(const Screw& s) {
    return std::numbers::pi / 2 * s.density * s.length * std::pow(s.radius, 4) + s.coupling_inertia;
}

double nut_stiffness(const Screw& s) {
    return 0.8 * s.nut_stiffness * std::cbrt(s.nut_preload / 0.1);
}

void add_spring(DriveMatrix& matrix, const Elongation& e, double value) {
    for (std::size_t i = 0; i < drive_order; ++i)
        for (std::size_t j = 0; j < drive_order; ++j) matrix[i][j] += value * e[i] * e[j];
}

void close_loop(Drive& drive, const DriveAxis& axis) {
    const double i = drive.ratio, bandwidth = 2 * std::numbers::pi * axis.servo.bandwidth;
    drive.inertia =
        drive.mass[motor] + drive.mass[screw_turn] + i * i * (axis.slave_mass + axis.table_mass);
    drive.kp = drive.inertia * bandwidth * bandwidth;
    drive.kd = 2 * axis.servo.damping * drive.inertia * bandwidth;
}

}  // namespace

Drive drive(const DriveAxis& axis, double nut_distance) {
    const Screw& s = axis.screw;
    BEAD_EXPECTS(nut_distance > 0 && nut_distance < s.length && axis.flexure > 0);
    Drive d;
    d.ratio = s.lead / (2 * std::numbers::pi);
    const double m1 = screw_mass(s), js = screw_inertia(s);
    d.mass = {m1, m1, axis.slave_mass, axis.table_mass, s.rotor_inertia, js};

    const double axial = in_series(s.bearing_stiffness, screw_stiffness(s, nut_distance));
    const double twist = in_series(s.coupling_stiffness, twist_stiffness(s, nut_distance));
    const double nut = nut_stiffness(s), ratio = axis.screw_damping;
    constexpr double twist_damper = 0.1, motor_damper = 1e-3;  // N m s, small beside the servo's
    const auto both = [&](const Elongation& e, double stiffness, double damping) {
        add_spring(d.stiffness, e, stiffness);
        add_spring(d.damping, e, damping);
    };
    both({1, 0, 0, 0, 0, 0}, axial, damper(ratio, axial, m1));
    both({0, 1, 0, 0, 0, 0}, axial, damper(ratio, axial, m1));
    both({-0.5, -0.5, 1, 0, 0, -d.ratio}, nut, damper(ratio, nut, axis.slave_mass));
    both({0, 0, -1, 1, 0, 0}, axis.flexure,
         damper(axis.flexure_damping, axis.flexure, axis.table_mass));
    both({0, 0, 0, 0, 1, -1}, twist, twist_damper);
    d.damping[motor][motor] += motor_damper;
    close_loop(d, axis);
    return d;
}

ClosedLoop closed_loop(const Drive& drive) {
    constexpr std::size_t n = drive_order;
    ClosedLoop loop{std::vector<double>(4 * n * n), std::vector<double>(2 * n)};
    const auto at = [&](std::size_t i, std::size_t j) -> double& {
        return loop.matrix[i * 2 * n + j];
    };
    for (std::size_t i = 0; i < n; ++i) {
        at(i, n + i) = 1;
        for (std::size_t j = 0; j < n; ++j) {
            at(n + i, j) = -drive.stiffness[i][j] / drive.mass[i];
            at(n + i, n + j) = -drive.damping[i][j] / drive.mass[i];
        }
    }
    at(n + motor, motor) -= drive.kp / drive.mass[motor];
    at(n + motor, n + motor) -= drive.kd / drive.mass[motor];
    loop.input[n + motor] = 1 / drive.mass[motor];
    return loop;
}

std::complex<double> gain(const Drive& drive, double omega) {
    constexpr std::size_t table = 3;
    const ClosedLoop loop = closed_loop(drive);
    const std::complex<double> s(0, omega);
    const std::complex<double> input = drive.kp + s * (drive.kd + s * drive.inertia);
    const auto modes = linear_modes(loop.matrix, 2 * drive_order);
    return steady_state(modes, loop.input, s)[table] * input / drive.ratio;
}

std::vector<DriveMode> drive_modes(const Drive& drive) {
    std::vector<DriveMode> modes;
    for (const LinearMode& mode : linear_modes(closed_loop(drive).matrix, 2 * drive_order))
        if (mode.eigenvalue.imag() > 0) modes.push_back({frequency(mode), damping_ratio(mode)});
    return modes;
}

DriveMode first_mode(const DriveAxis& axis) {
    const std::vector<DriveMode> modes = drive_modes(drive(axis));
    const auto rings = [](const DriveMode& mode) { return mode.damping < ringing; };
    const auto first = std::ranges::find_if(modes, rings);
    return first == modes.end() ? modes.front() : *first;
}

DriveAxis with_mode(DriveAxis axis, const DriveMode& measured) {
    BEAD_EXPECTS(measured.frequency > 0 && measured.damping >= 0 && measured.damping < ringing);
    constexpr double servo_above = 8;  // times the mode
    axis.servo.bandwidth = std::max(axis.servo.bandwidth, servo_above * measured.frequency);
    const double omega = 2 * std::numbers::pi * measured.frequency;
    axis.flexure = axis.table_mass * omega * omega;
    axis.flexure_damping = measured.damping;
    for (int i = 0; i < 50; ++i) {
        const DriveMode mode = first_mode(axis);
        const double stretch = measured.frequency / mode.frequency;
        axis.flexure *= stretch * stretch;
        axis.flexure_damping =
            std::max(0.0, axis.flexure_damping + measured.damping - mode.damping);
        if (std::abs(stretch - 1) < 1e-9 && std::abs(mode.damping - measured.damping) < 1e-9) break;
    }
    return axis;
}

}  // namespace bead
