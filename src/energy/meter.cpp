#include "energy/meter.h"

#include <algorithm>

#include "core/expects.h"
#include "energy/block_part.h"
#include "energy/tariff.h"

namespace bead {

namespace {

constexpr double warm = 50;  // °C, above which the hot end's fan runs

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
      bed_(power_.bed.heater, power_.bed.capacity, power_.ambient),
      standstill_(power_) {
    expect_sound(power_);
    for (const Motor& motor : power_.motors) standing_ += motor.standing;
}

void EnergyMeter::add(const MotionEvent& event) {
    std::visit([this](const auto& what) { take(what); }, event);
}

// Calls with the ends (s from now) of the pieces that the listener wants apart.
template <class Part>
void EnergyMeter::in_pieces(double seconds, const Part& part) {
    if (!listener_.hear) return part(0.0, seconds);
    const double start = elapsed();
    for (double from = 0; from < seconds;) {
        const double cut = listener_.next_cut(start + from) - start;
        const double to = cut > from ? std::min(cut, seconds) : seconds;
        part(from, to);
        from = to;
    }
}

void EnergyMeter::take(const Block& block) {
    const double seconds = duration(block), melt = melted(block.delta[axis_e]);
    in_pieces(seconds, [&](double from, double to) {
        const bool whole = from <= 0 && to >= seconds;
        pass({.duration = to - from,
              .motors = motors_of(whole ? block : part_of(block, from, to)),
              .melt = whole ? melt : melt * (to - from) / seconds,
              .role = block.role});
    });
    load_bed(melt);
}

MotorDraw EnergyMeter::motors_of(const Block& block) {
    if (kinematics_ != Kinematics::delta) return motor_draw(power_.motors, block, kinematics_);
    const Vec2 from = head_;
    head_ = head_ + Vec2{block.delta[axis_x], block.delta[axis_y]};
    return delta_draw(power_.motors, delta_, from, block);
}

void EnergyMeter::take(const Dwell& dwell) {
    in_pieces(dwell.duration, [&](double from, double to) { pass({.duration = to - from}); });
}

void EnergyMeter::take(const SetHeat& heat) {
    const bool hot = heat.heater == Heater::hotend;
    HeatedBody& body = hot ? hotend_ : bed_;
    body.aim(heat.celsius);
    if (!heat.wait) return;
    const double G = hot ? hotend_conductance() : bed_conductance();
    in_pieces(body.warm_up_time(G),
              [&](double from, double to) { pass({.duration = to - from, .heating = true}); });
}

void EnergyMeter::take(const SetFan& fan) { fan_duty_ = fan.duty; }

void EnergyMeter::take(const LayerStart& layer) { layers_.push_back({.z = layer.z}); }

// What is printed rides on the bed from now on.
void EnergyMeter::load_bed(double grams) {
    if (power_.bed_axis) power_.motors[*power_.bed_axis].moving_mass += grams * 1e-3;
}

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

// What the motors take for being energised.
EnergyMeter::Held EnergyMeter::held(const Stretch& stretch) {
    Held held{standing_ * stretch.duration, standing_};
    if (!standstill_.reduces()) return held;
    const PerAxis<double> reduced = standstill_.pass(stretch.duration, stretch.motors.turns);
    for (std::size_t slot = 0; slot < reduced.size(); ++slot) {
        held.energy -= standstill_.saving(slot) * reduced[slot];
        if (reduced[slot] >= stretch.duration) held.peak -= standstill_.saving(slot);
        sums_.reduced[slot] += reduced[slot];
    }
    return held;
}

// Warming what flows through takes heat in proportion to T - ambient, as a loss does.
void EnergyMeter::pass(const Stretch& stretch) {
    const double seconds = stretch.duration;
    if (seconds <= 0) return;
    const double flow = stretch.melt / seconds;
    const HeatDraw hotend = hotend_.advance(
        seconds, hotend_conductance() + flow * material_.heat_capacity, flow * material_.latent);
    const HeatDraw bed = bed_.advance(seconds, bed_conductance());
    const Held motors = held(stretch);
    const double fans = fan_power();
    const double low_voltage =
        hotend.peak + motors.peak + stretch.motors.peak + fans + power_.electronics;
    if (const double peak = bed.peak * bed_wall_ + low_voltage * wall_; peak > peak_power_) {
        peak_power_ = peak;
        peak_time_ = elapsed();
    }
    count(stretch, hotend.excess, bed.excess);
    book(stretch, {.bed = bed.energy * bed_wall_,
                   .hotend = hotend.energy * wall_,
                   .motors = (motors.energy + total(stretch.motors)) * wall_,
                   .fans = fans * seconds * wall_,
                   .electronics = power_.electronics * seconds * wall_});
}

// `hotend`, `bed`: K s above ambient.
void EnergyMeter::count(const Stretch& stretch, double hotend, double bed) {
    for (std::size_t slot = 0; slot < sums_.work.size(); ++slot) {
        sums_.speed[slot] += stretch.motors.speed[slot];
        sums_.work[slot] += stretch.motors.work[slot];
    }
    sums_.duty += fan_duty_ * stretch.duration;
    if (hotend_.target() > warm) sums_.warm += stretch.duration;
    sums_.hotend += hotend;
    sums_.blown += hotend * fan_duty_;
    sums_.plastic += hotend * stretch.melt / stretch.duration;
    if (hotend_.target() > power_.ambient) sums_.molten += stretch.melt;
    sums_.bed += bed;
}

void EnergyMeter::book(const Stretch& stretch, const Energy& energy) {
    if (listener_.hear) listener_.hear({elapsed(), stretch.duration, stretch.heating, energy});
    if (stretch.heating) {
        heat_up_ += energy;
        heat_up_duration_ += stretch.duration;
        return;
    }
    Layer& layer = layers_.empty() ? before_ : layers_.back();
    layer.by_role[static_cast<std::size_t>(stretch.role)] += energy;
    layer.duration += stretch.duration;
    duration_ += stretch.duration;
}

EnergyTerms EnergyMeter::terms() const {
    const HotEnd& h = power_.hotend;
    const double still = conductance(h.resistance_still), blown = conductance(h.resistance_blown);
    EnergyTerms terms;
    for (std::size_t slot = 0; slot < terms.motors.size(); ++slot)
        terms.motors[slot] = {.standing = power_.motors[slot].standing * elapsed(),
                              .resting = -standstill_.saving(slot) * sums_.reduced[slot],
                              .speed = sums_.speed[slot],
                              .work = sums_.work[slot]};
    if (h.heater > 0)
        terms.hotend = {.stored = hotend_.stored(),
                        .lost = still * sums_.hotend,
                        .blown = (blown - still) * sums_.blown,
                        .warming = material_.heat_capacity * sums_.plastic,
                        .melting = material_.latent * sums_.molten};
    if (power_.bed.heater > 0)
        terms.bed = {.stored = bed_.stored(), .lost = bed_conductance() * sums_.bed};
    terms.part_fan = power_.part_fan * sums_.duty;
    terms.hotend_fan = power_.hotend_fan * sums_.warm;
    terms.electronics = power_.electronics * elapsed();
    const double bed = total(terms.bed), all = total(terms);
    terms.supply = (wall_ - 1) * (all - bed) + (bed_wall_ - 1) * bed;
    return terms;
}

EnergyReport EnergyMeter::report() const {
    EnergyReport report;
    const auto add = [&](const PerRole<Energy>& by_role) {
        double joules = 0;
        for (std::size_t role = 0; role < by_role.size(); ++role) {
            report.consumers_by_role[role] += by_role[role];
            joules += total(by_role[role]);
        }
        return joules;
    };
    report.before_layers = add(before_.by_role);
    for (const Layer& layer : layers_)
        report.by_layer.push_back({layer.z, layer.duration, add(layer.by_role), layer.by_role});
    report.heat_up_consumers = heat_up_;
    report.consumers_by_role[static_cast<std::size_t>(Role::other)] += heat_up_;
    for (std::size_t role = 0; role < report.by_role.size(); ++role) {
        report.energy += report.consumers_by_role[role];
        report.by_role[role] = total(report.consumers_by_role[role]);
    }
    report.heat_up = total(heat_up_);
    report.heat_up_duration = heat_up_duration_;
    report.duration = duration_;
    report.peak_power = peak_power_;
    report.peak_time = peak_time_;
    report.co2 = total(report.energy) / joules_per_kwh * power_.grid_co2;
    report.terms = terms();
    for (std::size_t slot = 0; slot < power_.motors.size(); ++slot)
        if (turns_in_xy(kinematics_, slot))
            report.xy_motors += wall_ * total(report.terms.motors[slot]);
    return report;
}

}  // namespace bead
