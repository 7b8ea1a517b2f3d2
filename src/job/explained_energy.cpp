#include "job/explained_energy.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bead {
namespace {

using Terms = std::vector<ExplainedTerm>;

Parameter power(std::string_view key, double value) {
    return {fmt::format("power.{}", key), value};
}

Parameter of_motor(std::string_view key, std::size_t slot, double value) {
    return {fmt::format("power.motors.{}[{}]", key, slot), value};
}

std::vector<Parameter> held(std::size_t slot, const Motor& motor, double delay) {
    return {of_motor("standing_w", slot, motor.standing),
            of_motor("holding_w", slot, holding(motor)), power("motors.standstill_delay_s", delay)};
}

std::vector<Parameter> pushing(std::size_t slot, const Motor& motor) {
    return {of_motor("friction_n", slot, motor.friction),
            of_motor("moving_mass_kg", slot, motor.moving_mass),
            of_motor("efficiency", slot, motor.efficiency)};
}

// Of a winding whose resistance is known, the current is what the file has.
std::vector<Parameter> standing(std::size_t slot, const Motor& motor) {
    if (motor.resistance <= 0) return {of_motor("standing_w", slot, motor.standing)};
    const double current = std::sqrt(motor.standing / (2 * motor.resistance));
    return {of_motor("run_current_a", slot, current),
            of_motor("winding_ohm", slot, motor.resistance)};
}

void add_motor(Terms& all, const MotorTerms& t, std::size_t slot, const PowerModel& p) {
    constexpr std::array names{"X", "Y", "Z", "E"};
    const Motor& motor = p.motors[slot];
    const auto name = [&](std::string_view what) {
        return fmt::format("motor {} {}", names[slot], what);
    };
    all.push_back({"motors", name("standing"), "standing · time = 2 R I² · time",
                   standing(slot, motor), t.standing});
    if (holding(motor) < motor.standing)
        all.push_back({"motors", name("at rest"),
                       "-(standing - holding) · time at rest beyond the delay",
                       held(slot, motor, p.standstill_delay), t.resting});
    all.push_back({"motors",
                   name("turning"),
                   "per_speed · way of the motor",
                   {of_motor("per_speed_w_per_mm_s", slot, motor.per_speed)},
                   t.speed});
    const bool carries = p.bed_axis == slot;
    all.push_back({"motors", name("pushing"),
                   carries ? "∫ max(0, (F ± (m + printed) a) v) dt / efficiency"
                           : "∫ max(0, (F ± m a) v) dt / efficiency",
                   pushing(slot, motor), t.work});
}

void add_hotend(Terms& all, const HeatTerms& t, const Printer& printer, const Material& plastic) {
    const PowerModel& p = printer.power;
    const Parameter ambient = power("ambient_c", p.ambient);
    const Parameter still = power("hotend.resistance_still_k_w", p.hotend.resistance_still);
    all.push_back({"hotend",
                   "stored in the hot end",
                   "C (T at the end - ambient)",
                   {power("hotend.capacity_j_k", p.hotend.capacity), ambient},
                   t.stored});
    all.push_back(
        {"hotend", "lost to still air", "∫ (T - ambient) dt / R_still", {still, ambient}, t.lost});
    all.push_back(
        {"hotend",
         "blown away by the part fan",
         "∫ duty (T - ambient) dt (1/R_blown - 1/R_still)",
         {power("hotend.resistance_blown_k_w", p.hotend.resistance_blown), still, ambient},
         t.blown});
    all.push_back({"hotend",
                   "warming plastic",
                   "mass · heat capacity · (T - ambient)",
                   {{"heat_capacity_j_gk", plastic.heat_capacity, ParameterFrom::material},
                    {"density_g_cm3", plastic.density, ParameterFrom::material},
                    {"filament_mm", printer.filament}},
                   t.warming});
    if (plastic.latent > 0)
        all.push_back({"hotend",
                       "melting plastic",
                       "mass · latent heat",
                       {{"latent_j_g", plastic.latent, ParameterFrom::material}},
                       t.melting});
}

void add_bed(Terms& all, const HeatTerms& t, const PowerModel& p) {
    const Parameter ambient = power("ambient_c", p.ambient);
    all.push_back({"bed",
                   "stored in the bed",
                   "C (T at the end - ambient)",
                   {power("bed.capacity_j_k", p.bed.capacity), ambient},
                   t.stored});
    all.push_back({"bed",
                   "lost by the bed",
                   "∫ (T - ambient) dt / R",
                   {power("bed.resistance_k_w", p.bed.resistance), ambient},
                   t.lost});
}

}  // namespace

Terms explained(const EnergyTerms& t, const Printer& printer, const Material& material) {
    const PowerModel& p = printer.power;
    Terms all;
    add_bed(all, t.bed, p);
    add_hotend(all, t.hotend, printer, material);
    for (std::size_t slot = 0; slot < t.motors.size(); ++slot)
        add_motor(all, t.motors[slot], slot, p);
    all.push_back(
        {"fans", "part fan", "power · ∫ duty dt", {power("part_fan_w", p.part_fan)}, t.part_fan});
    all.push_back({"fans",
                   "hot end's fan",
                   "power · time with a target above 50 °C",
                   {power("hotend_fan_w", p.hotend_fan)},
                   t.hotend_fan});
    all.push_back({"electronics",
                   "electronics",
                   "power · time",
                   {power("electronics_w", p.electronics)},
                   t.electronics});
    all.push_back(
        {"supply",
         p.bed.mains ? "lost in the supply, the bed is on the mains" : "lost in the supply",
         "(1/efficiency - 1) · all it feeds",
         {power("supply_efficiency", p.supply_efficiency)},
         t.supply});
    return all;
}

Terms explained_published(const Features& f, const MotorCoefficients& k) {
    constexpr ParameterFrom published = ParameterFrom::publication;
    const std::string_view xy = "motors";
    return {{xy, "accelerating along X", "kA A", {{"kA_j_per_mm2_s2", k.a, published}}, k.a * f.A},
            {xy, "accelerating along Y", "kB B", {{"kB_j_per_mm2_s2", k.b, published}}, k.b * f.B},
            {xy, "coasting", "kC C", {{"kC_j_per_mm", k.c, published}}, k.c * f.C},
            {xy, "standing exactly still", "kH H", {{"kH_w", k.h, published}}, k.h * f.H}};
}

Terms explained_standing(const Features& f, const MotorCoefficients& k, double usual_speed) {
    constexpr ParameterFrom published = ParameterFrom::publication;
    Terms terms = explained_published(f, k);
    const double coasting = std::max(0.0, k.c - k.h / usual_speed);
    terms[2] = {terms[2].consumer,
                "coasting, above standing",
                "max(0, kC - kH / usual speed) C",
                {{"kC_j_per_mm", k.c, published},
                 {"kH_w", k.h, published},
                 {"usual_speed_mm_s", usual_speed, published}},
                coasting * f.C};
    terms[3] = {terms[3].consumer,
                "standing, moving or not",
                "kH (time of X + time of Y)",
                {{"kH_w", k.h, published}},
                k.h * f.axis_time};
    return terms;
}

double total(const Terms& terms) {
    double sum = 0;
    for (const ExplainedTerm& term : terms) sum += term.joules;
    return sum;
}

}  // namespace bead
