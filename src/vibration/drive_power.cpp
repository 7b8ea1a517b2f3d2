#include "vibration/drive_power.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bead {
namespace {

constexpr double gravity = 9.81;    // m/s²
constexpr double soft_speed = 0.5;  // rad/s, below which friction fades: it has no sign at rest
constexpr double joules_per_kwh = 3.6e6;

double friction_of(const DriveAxis& axis) {
    const double ratio = axis.screw.lead / (2 * std::numbers::pi);
    const double weight = (axis.slave_mass + axis.table_mass) * gravity;
    return axis.servo.friction + axis.servo.rolling * weight * ratio;
}

double softened_sign(double x) {
    constexpr double saturated = 20;
    if (std::abs(x) > saturated) return x > 0 ? 1 : -1;
    return std::tanh(x);
}

}  // namespace

void add_work(DriveEnergy& energy, const DriveAxis& axis, const DriveSample& sample, double step) {
    const double torque =
        sample.torque + friction_of(axis) * softened_sign(sample.turning / soft_speed);
    const double current = torque / axis.servo.torque_constant;
    energy.servo += std::max(0.0, torque * sample.turning) * step;
    energy.copper += axis.servo.resistance * current * current * step;
}

void add_other_energy(Response& response, const ShakenMachine& machine) {
    const Material& m = machine.material;
    const double ambient = 25;  // °C
    response.material = response.volume * m.density * 1e-3;
    const double heat = m.heat_capacity * (m.hotend - ambient) + m.latent;  // J/g
    response.energy.melt = response.material * heat / machine.model.melt_efficiency;
    response.energy.base = machine.model.base_power * response.time;
    response.co2 = 1000 * machine.model.energy_co2 * total(response.energy) / joules_per_kwh +
                   machine.model.material_co2 * response.material;
}

}  // namespace bead
