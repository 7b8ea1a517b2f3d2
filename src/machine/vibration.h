// What shakes in a machine: per axis a table on a flexure, pulled by a nut on two ball screws that
// a servo turns (the lumped masses of docs/vibration.md). SI units throughout: kg, m, N, rad, Hz,
// W. The defaults are those of a portal machine of 1.2 x 1.0 m with its first modes at 14 and 22
// Hz.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

namespace bead {

enum class ScrewSupport : std::uint8_t { fixed_free, fixed_fixed };

struct Screw {
    double radius = 0.010, length = 1.1, lead = 0.020;           // m, lead per turn
    double density = 7850, young = 206e9, shear = 79e9;          // kg/m³, Pa, Pa
    double rotor_mass = 0.8, coupling_mass = 0.2;                // kg, that move with the screw
    double rotor_inertia = 1e-4, coupling_inertia = 2e-5;        // kg m²
    double bearing_stiffness = 1.2e8, coupling_stiffness = 3e3;  // N/m, N m/rad
    double nut_stiffness = 2e8;                                  // N/m, of the catalogue
    double nut_preload = 0.05;                                   // of the nut's dynamic load rating
    ScrewSupport support = ScrewSupport::fixed_free;
    double nut_distance = 0.55;  // m, from coupling to nut, which decides how stiff the screw is
    // m, the axis' place with the nut at the coupling; then the nut's distance follows the print.
    std::optional<double> coupling_at{};
};

struct Servo {
    double bandwidth = 40, damping = 0.8;             // Hz, ratio, of the position loop
    double friction = 0.08;                           // N m, constant
    double rolling = 0.01;                            // N of friction per N of moved weight
    double torque_constant = 0.35, resistance = 1.0;  // N m/A, ohm
};

struct DriveAxis {
    double slave_mass = 18, table_mass = 9;  // kg, nut's side and nozzle's side of the flexure
    double flexure = 69'640;                 // N/m
    double flexure_damping = 0.04;           // ratios, of each spring with the mass it carries
    double screw_damping = 0.02;
    Screw screw{};
    Servo servo{};
};

struct VibrationModel {
    std::array<DriveAxis, 2> axes{
        // X, Y
        DriveAxis{}, DriveAxis{.slave_mass = 5,
                               .table_mass = 6,
                               .flexure = 114'640,
                               .screw = {.length = 0.9, .nut_distance = 0.45}}};
    double base_power = 180;       // W: control, bed, fans, what the hot end loses
    double melt_efficiency = 0.6;  // heat in the melt / heat of the heater
    double energy_co2 = 0.4;       // kg per kWh
    double material_co2 = 2.0;     // kg per kg
};

}  // namespace bead
