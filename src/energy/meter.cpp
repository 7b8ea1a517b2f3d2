#include "energy/meter.h"

#include <algorithm>
#include <numeric>

#include "core/expects.h"

namespace bead {

namespace {

constexpr double warm = 50;  // °C, above which the hot end's fan runs
constexpr double joules_per_kwh = 3.6e6;

double conductance(double resistance) { return resistance > 0 ? 1 / resistance : 0; }

// W at the wall per W of the bed.
double bed_supply(const PowerModel& power) {
    return power.bed.mains ? 1 : 1 / power.supply_efficiency;
}

void expect_sound(const PowerModel& power) {
    BEAD_EXPECTS(power.supply_efficiency > 0);
    BEAD_EXPECTS(
        std::ranges::all_of(power.motors, [](const Motor& m) { return m.efficiency > 0; }));
    BEAD_EXPECTS(power.bed.heater <= 0 || power.bed.resistance > 0);
    BEAD_EXPECTS(power.hotend.heater <= 0 ||
                 (power.hotend.resistance_still > 0 && power.hotend.resistance_blown > 0));
}

Printer cartesian_printer(const PowerModel& power, double filament) {
    Printer printer;
    printer.power = power;
    printer.filament = filament;
    return printer;
}

}  // namespace

Energy operator+(const Energy& a, const Energy& b) {
    return {a.bed + b.bed, a.hotend + b.hotend, a.motors + b.motors, a.fans + b.fans,
            a.electronics + b.electronics};
}

Energy operator-(const Energy& a, const Energy& b) {
    return {a.bed - b.bed, a.hotend - b.hotend, a.motors - b.motors, a.fans - b.fans,
            a.electronics - b.electronics};
}

double total(const Energy& energy) {
    return energy.bed + energy.hotend + energy.motors + energy.fans + energy.electronics;
}

EnergyMeter::EnergyMeter(const PowerModel& power, const Material& material,
                         double filament_diameter)
    : EnergyMeter(cartesian_printer(power, filament_diameter), material) {}

EnergyMeter::EnergyMeter(const Printer& printer, const Material& material)
    : power_(printer.power),
      material_(material),
      kinematics_(printer.kinematics),
      delta_(printer.delta),
      grams_per_mm_(pi / 4 * printer.filament * printer.filament * material.density * 1e-3),
      wall_(1 / power_.supply_efficiency),
      bed_wall_(bed_supply(power_)),
      hotend_(power_.hotend.heater, power_.hotend.capacity, power_.ambient),
      bed_(power_.bed.heater, power_.bed.capacity, power_.ambient) {
    expect_sound(power_);
    for (std::size_t slot = 0; slot < power_.motors.size(); ++slot) {
        standing_ += power_.motors[slot].standing;
        if (turns_in_xy(kinematics_, slot)) standing_xy_ += power_.motors[slot].standing;
    }
}

void EnergyMeter::add(const MotionEvent& event) {
    std::visit([this](const auto& what) { take(what); }, event);
}

EnergyReport EnergyMeter::report() const {
    EnergyReport report = sum_;
    report.co2 = total(sum_.energy) / joules_per_kwh * power_.grid_co2;
    return report;
}

void EnergyMeter::take(const Block& block) {
    pass({.duration = duration(block),
          .motors = motors_of(block),
          .melt = melted(block.delta[axis_e]),
          .role = block.role});
}

MotorDraw EnergyMeter::motors_of(const Block& block) {
    if (kinematics_ != Kinematics::delta) return motor_draw(power_.motors, block, kinematics_);
    const Vec2 from = head_;
    head_ = head_ + Vec2{block.delta[axis_x], block.delta[axis_y]};
    return delta_draw(power_.motors, delta_, from, block);
}

void EnergyMeter::take(const Dwell& dwell) { pass({.duration = dwell.duration}); }

void EnergyMeter::take(const SetHeat& heat) {
    const bool hot = heat.heater == Heater::hotend;
    HeatedBody& body = hot ? hotend_ : bed_;
    body.aim(heat.celsius);
    if (!heat.wait) return;
    const double G = hot ? hotend_conductance() : bed_conductance();
    pass({.duration = body.warm_up_time(G), .heating = true});
}

void EnergyMeter::take(const SetFan& fan) { fan_duty_ = fan.duty; }

void EnergyMeter::take(const LayerStart& layer) { sum_.by_layer.push_back({.z = layer.z}); }

// Plastic that was pulled back and is pushed again has been melted before.
double EnergyMeter::melted(double filament) {
    const double fresh = std::max(0.0, filament - retracted_);
    retracted_ = std::max(0.0, retracted_ - filament);
    return fresh * grams_per_mm_;
}

// Between still and blown air the conductance, not the resistance, is taken as linear in the duty.
double EnergyMeter::hotend_conductance() const {
    const double still = conductance(power_.hotend.resistance_still);
    const double blown = conductance(power_.hotend.resistance_blown);
    return still + (blown - still) * fan_duty_;
}

double EnergyMeter::bed_conductance() const { return conductance(power_.bed.resistance); }

double EnergyMeter::fan_power() const {
    return power_.part_fan * fan_duty_ + (hotend_.target() > warm ? power_.hotend_fan : 0);
}

// Warming what flows through takes heat in proportion to T - ambient, as a loss does.
void EnergyMeter::pass(const Stretch& stretch) {
    const double seconds = stretch.duration;
    if (seconds <= 0) return;
    const double flow = stretch.melt / seconds;
    const HeatDraw hotend = hotend_.advance(
        seconds, hotend_conductance() + flow * material_.heat_capacity, flow * material_.latent);
    const HeatDraw bed = bed_.advance(seconds, bed_conductance());
    const double fans = fan_power();
    book(stretch, {.bed = bed.energy * bed_wall_,
                   .hotend = hotend.energy * wall_,
                   .motors = (standing_ * seconds + stretch.motors.all) * wall_,
                   .fans = fans * seconds * wall_,
                   .electronics = power_.electronics * seconds * wall_});
    sum_.xy_motors += (standing_xy_ * seconds + stretch.motors.xy) * wall_;
    const double low_voltage =
        hotend.peak + standing_ + stretch.motors.peak + fans + power_.electronics;
    sum_.peak_power = std::max(sum_.peak_power, bed.peak * bed_wall_ + low_voltage * wall_);
}

void EnergyMeter::book(const Stretch& stretch, const Energy& energy) {
    const double joules = total(energy);
    sum_.energy = sum_.energy + energy;
    sum_.by_role[static_cast<std::size_t>(stretch.role)] += joules;
    (stretch.heating ? sum_.heat_up_duration : sum_.duration) += stretch.duration;
    if (stretch.heating) {
        sum_.heat_up += joules;
    } else if (sum_.by_layer.empty()) {
        sum_.before_layers += joules;
    } else {
        sum_.by_layer.back().total += joules;
        sum_.by_layer.back().duration += stretch.duration;
    }
}

}  // namespace bead
