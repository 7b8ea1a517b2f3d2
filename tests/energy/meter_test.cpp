#include "energy/meter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "support/any_print.h"
#include "support/power_twin.h"

namespace bead {
namespace {

using namespace test;
using test::measured;  // beside the one below

double sum_of_layers(const EnergyReport& report) {
    return std::accumulate(report.by_layer.begin(), report.by_layer.end(), 0.0,
                           [](double sum, const LayerEnergy& l) { return sum + l.total; });
}

RC_GTEST_PROP(EnergyMeter, LosesNothing, ()) {
    const EnergyReport r = measured(any_print());
    const double all = total(r.energy);
    RC_ASSERT(near(all, std::accumulate(r.by_role.begin(), r.by_role.end(), 0.0)));
    RC_ASSERT(near(all, r.heat_up + r.before_layers + sum_of_layers(r)));
    RC_ASSERT(near(r.co2, all / 3.6e6 * 360));
    RC_ASSERT(r.xy_motors <= r.energy.motors);
    RC_ASSERT(all <= r.peak_power * (r.duration + r.heat_up_duration) * (1 + 1e-9));
}

constexpr std::array machines{Kinematics::cartesian, Kinematics::corexy, Kinematics::corexz,
                              Kinematics::delta};

Printer printer_of(Kinematics kinematics) {
    Printer printer;
    printer.kinematics = kinematics;
    printer.delta = {.arm = 4000, .radius = 2000, .head_mass = 0.3};  // any print is in reach
    printer.filament = thin;
    printer.power = desktop();
    return printer;
}

EnergyReport measured(const Stream& stream, Kinematics kinematics) {
    EnergyMeter meter(printer_of(kinematics), plain);
    for (const MotionEvent& event : stream) meter.add(event);
    return meter.report();
}

RC_GTEST_PROP(EnergyMeter, LosesNothingOnAnyKinematics, ()) {
    const Stream stream = any_print();
    const EnergyReport cartesian = measured(stream);
    for (const Kinematics kinematics : machines) {
        const EnergyReport r = measured(stream, kinematics);
        const double all = total(r.energy);
        RC_ASSERT(near(all, std::accumulate(r.by_role.begin(), r.by_role.end(), 0.0)));
        RC_ASSERT(near(all, r.heat_up + r.before_layers + sum_of_layers(r)));
        RC_ASSERT(near(all - r.energy.motors, total(cartesian.energy) - cartesian.energy.motors));
        RC_ASSERT(r.xy_motors <= r.energy.motors);
        RC_ASSERT(all <= r.peak_power * (r.duration + r.heat_up_duration) * (1 + 1e-9));
    }
    RC_ASSERT(total(measured(stream, Kinematics::cartesian).energy) == total(cartesian.energy));
}

TEST(EnergyMeter, FollowsTheHeadOfADelta) {
    Printer printer = printer_of(Kinematics::delta);
    printer.delta = {.arm = 300, .radius = 160, .head_mass = 0.3};
    printer.power.supply_efficiency = 1;
    for (Motor& motor : printer.power.motors) motor.standing = 0;
    const Block there = trapezoid({60, 0, 0, 0}, 0, 0, 80, 1000);
    const Block back = trapezoid({-60, 0, 0, 0}, 0, 0, 80, 1000);
    EnergyMeter meter(printer, plain);
    meter.place({20, 10});
    for (const Block& block : {there, back, there}) meter.add(block);
    EXPECT_EQ(meter.place(), (Vec2{80, 10}));
    const double out = total(delta_draw(printer.power.motors, printer.delta, {20, 10}, there));
    const double home = total(delta_draw(printer.power.motors, printer.delta, {80, 10}, back));
    EXPECT_NEAR(meter.report().energy.motors, 2 * out + home, 1e-9);
}

RC_GTEST_PROP(EnergyMeter, DoesNotCareWhereAPrintStands, ()) {
    Stream stream = any_print(), mirrored = stream;
    for (MotionEvent& event : mirrored)
        if (Block* block = std::get_if<Block>(&event)) block->delta[axis_x] *= -1;
    RC_ASSERT(total(measured(stream).energy) == total(measured(mirrored).energy));
}

RC_GTEST_PROP(EnergyMeter, WithEqualMotorsExchangesWithTheAxes, ()) {
    PowerModel power = desktop();
    power.motors[axis_y] = power.motors[axis_x];
    const Stream stream = any_print();
    Stream turned = stream;
    for (MotionEvent& event : turned)
        if (Block* block = std::get_if<Block>(&event))
            std::swap(block->delta[axis_x], block->delta[axis_y]);
    RC_ASSERT(near(total(measured(stream, power).energy), total(measured(turned, power).energy)));
}

RC_GTEST_PROP(EnergyMeter, ChargesElectronicsForEverySecond, ()) {
    const Stream stream = any_print();
    PowerModel hungry = desktop();
    hungry.electronics += 4;
    const EnergyReport a = measured(stream), b = measured(stream, hungry);
    const double seconds = a.duration + a.heat_up_duration;
    RC_ASSERT(near(total(b.energy) - total(a.energy), 4 * seconds / 0.8));
}

RC_GTEST_PROP(EnergyMeter, TakesPartsAsItTakesTheWhole, ()) {
    const Block block = any_block();
    RC_PRE(block.t_cruise > 1e-6);
    Block first = block, second = block;
    first.t_decel = second.t_accel = 0;
    first.t_cruise = second.t_cruise = block.t_cruise / 2;
    first.v_exit = second.v_entry = block.v_peak;
    const double cut =
        ((first.v_entry + first.v_peak) / 2 * first.t_accel + first.v_peak * first.t_cruise) /
        block.length;
    for (double& d : first.delta) d *= cut;
    for (double& d : second.delta) d *= 1 - cut;
    first.length *= cut;
    second.length *= 1 - cut;
    const SetHeat warm{Heater::hotend, 200, true};
    PowerModel strong = desktop();
    strong.hotend.heater = 1e6;  // no flow cools it below its target
    RC_ASSERT(near(total(measured({warm, block}, strong).energy),
                   total(measured({warm, first, second}, strong).energy)));
}

TEST(EnergyMeter, DoublesStandingEnergyWithDuration) {
    PowerModel power;
    for (Motor& motor : power.motors) motor.standing = 1;
    Block block = trapezoid({100, 0, 0, 0}, 0, 0, 80, 1000), slow = block;
    slow.t_accel *= 2;
    slow.t_cruise *= 2;
    slow.t_decel *= 2;
    EXPECT_DOUBLE_EQ(total(measured({block}, power).energy), 4 * duration(block));
    EXPECT_DOUBLE_EQ(total(measured({slow}, power).energy),
                     2 * total(measured({block}, power).energy));
}

TEST(EnergyMeter, ByHandWhileItPrints) {
    Block block = trapezoid({100, 0, 0, 4}, 0, 0, 80, 1000);
    block.role = Role::infill;
    const Stream stream{SetHeat{Heater::bed, 60, true}, SetHeat{Heater::hotend, 215, true},
                        SetFan{1}, LayerStart{0.2, 0.2}, block};
    const EnergyReport r = measured(stream);
    const double T = 1.33, grams = pi / 4 * thin * thin * 4 * 1.25e-3;
    const Energy low{.bed = 35 * T,
                     .hotend = 19 * T + grams * (2 * 190 + 10),
                     .motors = 5.7 * T + 0.05 * 100 + 2e-3 * 93.6 + 3.2e-3 * (2 + 0.7) +
                               2e-3 * 1.3 * 3.2 + 30e-3 * 4,
                     .fans = 3 * T,
                     .electronics = 9 * T};
    const double braking_saved = 2e-3 * 1.3 * 3.2 - 3.2e-3 * (2 - 0.7);
    EXPECT_NEAR(r.by_role[static_cast<std::size_t>(Role::infill)],
                (total(low) - braking_saved) / 0.8, 1e-9);
    EXPECT_NEAR(r.by_layer.at(0).total, (total(low) - braking_saved) / 0.8, 1e-9);
    EXPECT_NEAR(r.by_layer.at(0).duration, T, 1e-12);
}

TEST(EnergyMeter, HeatsTogetherWhatIsNotWaitedFor) {
    const SetHeat bed{Heater::bed, 60, false}, hotend{Heater::hotend, 215, false};
    SetHeat bed_wait = bed, hotend_wait = hotend;
    bed_wait.wait = hotend_wait.wait = true;
    const EnergyReport together = measured({bed, hotend, bed_wait, hotend_wait});
    const EnergyReport in_turn = measured({bed_wait, hotend_wait});
    EXPECT_LT(together.heat_up_duration, in_turn.heat_up_duration);
    EXPECT_LT(total(together.energy), total(in_turn.energy));
    EXPECT_NEAR(together.peak_power, (150 + 38 + 1 + 9 + 5.7) / 0.8, 1e-9);
    EXPECT_NEAR(in_turn.peak_power, (150 + 9 + 5.7) / 0.8, 1e-9);
    EXPECT_EQ(together.duration, 0);
}

TEST(EnergyMeter, ChargesNoHeatToAFileWithoutTemperatures) {
    const EnergyReport r = measured({SetFan{1}, trapezoid({100, 0, 0, 4}, 0, 0, 80, 1000)});
    EXPECT_EQ(r.energy.bed, 0);
    EXPECT_EQ(r.energy.hotend, 0);
    EXPECT_NEAR(r.energy.fans, 2 * 1.33 / 0.8, 1e-12);
}

TEST(EnergyMeter, MeltsNothingTwice) {
    const SetHeat warm{Heater::hotend, 215, true};
    const auto filament = [](double mm) { return trapezoid({0, 0, 0, mm}, 0, 0, 30, 1000); };
    const double idle = measured({warm, Dwell{2 * duration(filament(2))}}).energy.hotend;
    EXPECT_NEAR(measured({warm, filament(-2), filament(2)}).energy.hotend, idle, 1e-9);
    EXPECT_GT(measured({warm, filament(2), filament(-2)}).energy.hotend, idle + 1);
}

TEST(EnergyMeter, FeedsABedOnTheMainsWithoutTheSupply) {
    PowerModel power = desktop();
    power.bed.mains = true;
    const Stream stream{SetHeat{Heater::bed, 60, true}};
    EXPECT_NEAR(measured(stream, power).energy.bed, 0.8 * measured(stream).energy.bed, 1e-9);
}

}  // namespace
}  // namespace bead
