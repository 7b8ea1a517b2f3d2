// What any sound account of energy obeys, over random prints.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "energy/power_curve.h"
#include "energy/tariff.h"
#include "motion/planner.h"
#include "support/any_print.h"
#include "support/random_program.h"

namespace bead {
namespace {

using namespace test;

// Whose driver saves at rest, whose bed carries the part.
PowerModel bed_slinger() {
    PowerModel power = desktop();
    for (Motor& motor : power.motors) motor.holding = motor.standing / 2;
    power.standstill_delay = 0.6;
    power.bed_axis = axis_y;
    return power;
}

Stream planned(const std::vector<Command>& program) {
    Stream stream;
    const auto planner =
        make_planner(Limits{}, {}, [&](const MotionEvent& event) { stream.push_back(event); });
    for (const Command& command : program) planner->add(command);
    planner->finish();
    return stream;
}

Stream planned(unsigned seed) { return planned(random_program(seed, {.moves = 60})); }

RC_GTEST_PROP(EnergyLaws, TermsSumToTheTotal, ()) {
    const EnergyReport r = measured(any_print(), bed_slinger());
    RC_ASSERT(near(total(r.energy), total(r.terms)));
    RC_ASSERT(near(r.energy.bed, (total(r.terms.bed)) / 0.8));
    RC_ASSERT(near(r.energy.hotend, total(r.terms.hotend) / 0.8));
    double motors = 0;
    for (const MotorTerms& motor : r.terms.motors) {
        motors += total(motor);
        RC_ASSERT(motor.resting <= 0 && motor.standing + motor.resting >= 0);
    }
    RC_ASSERT(near(r.energy.motors, motors / 0.8));
}

RC_GTEST_PROP(EnergyLaws, ConsumersByLayerAndRoleSumToTheTotal, ()) {
    const EnergyReport r = measured(any_print());
    for (double Energy::*who :
         {&Energy::bed, &Energy::hotend, &Energy::motors, &Energy::fans, &Energy::electronics}) {
        double by_role = 0;
        for (const Energy& energy : r.consumers_by_role) by_role += energy.*who;
        RC_ASSERT(near(by_role, r.energy.*who));
    }
    for (const LayerEnergy& layer : r.by_layer) {
        Energy sum;
        for (const Energy& energy : layer.by_role) sum += energy;
        RC_ASSERT(near(total(sum), layer.total));
    }
}

RC_GTEST_PROP(EnergyLaws, AddUpOverMoves, ()) {
    const Stream stream = planned(*rc::gen::arbitrary<unsigned>());
    PowerModel power = desktop();
    double sum = 0;
    for (const MotionEvent& event : stream) sum += total(measured({event}, power).energy);
    RC_ASSERT(near(sum, total(measured(stream, power).energy)));
}

RC_GTEST_PROP(EnergyLaws, DoNotCareWhereAProgramStands, ()) {
    std::vector<Command> program = random_program(*rc::gen::arbitrary<unsigned>(), {.moves = 60});
    Limits limits;  // on whole steps, so that rounding is the same everywhere
    for (const Axis axis : {axis_x, axis_y}) limits.steps_per_mm[axis] = 128;
    for (Command& command : program)
        if (Move* move = std::get_if<Move>(&command.what))
            for (const Axis axis : {axis_x, axis_y})
                move->to[axis] = std::round(move->to[axis] * 64) / 64;
    // The way to the first place is not part of the print.
    const auto printed = [&](const std::vector<Command>& commands) {
        Stream stream;
        const auto planner =
            make_planner(limits, {}, [&](const MotionEvent& event) { stream.push_back(event); });
        const Position& at = std::get<Move>(commands.front().what).to;
        planner->add({SetPosition{{at[0], at[1], at[2], at[3]}}, 0});
        for (const Command& command : commands) planner->add(command);
        planner->finish();
        return measured(stream, bed_slinger());
    };
    const double before = total(printed(program).energy);
    const double x = *rc::gen::inRange(-50, 50), y = *rc::gen::inRange(-50, 50);
    for (Command& command : program)
        if (Move* move = std::get_if<Move>(&command.what)) {
            move->to[axis_x] += x;
            move->to[axis_y] += y;
        }
    RC_ASSERT(std::abs(total(printed(program).energy) - before) < 1e-9 * before);
}

RC_GTEST_PROP(EnergyLaws, GrowWithTheBasePower, ()) {
    const Stream stream = any_print();
    PowerModel more = bed_slinger();
    const double before = total(measured(stream, more).energy);
    more.electronics += number_between(0, 20);
    RC_ASSERT(total(measured(stream, more).energy) >= before);
}

RC_GTEST_PROP(EnergyLaws, ExchangeXAndYWithTheBed, ()) {
    PowerModel power = bed_slinger();
    power.motors[axis_y] = power.motors[axis_x];
    const Stream stream = any_print();
    Stream turned = stream;
    for (MotionEvent& event : turned)
        if (Block* block = std::get_if<Block>(&event))
            std::swap(block->delta[axis_x], block->delta[axis_y]);
    PowerModel other = power;
    other.bed_axis = axis_x;
    RC_ASSERT(near(total(measured(stream, power).energy), total(measured(turned, other).energy)));
}

RC_GTEST_PROP(EnergyLaws, NeverPayForHoldingWithLess, ()) {
    const Stream stream = any_print();
    PowerModel saving = desktop();
    const double full = total(measured(stream, saving).energy);
    for (Motor& motor : saving.motors) motor.holding = number_between(0, motor.standing);
    saving.standstill_delay = number_between(0, 3);
    const EnergyReport sooner = measured(stream, saving);
    RC_ASSERT(total(sooner.energy) <= full * (1 + 1e-12));
    saving.standstill_delay += 1;
    RC_ASSERT(total(sooner.energy) <= total(measured(stream, saving).energy) * (1 + 1e-12));
}

// Without friction: what moves already would cover it, the more the heavier it is.
RC_GTEST_PROP(EnergyLaws, AHeavierPartNeverCostsLess, ()) {
    const Stream stream = any_print();
    PowerModel power = desktop();
    power.motors[axis_y].friction = 0;
    const double light = total(measured(stream, power).energy);
    power.bed_axis = axis_y;
    RC_ASSERT(total(measured(stream, power).energy) >= light * (1 - 1e-12));
}

struct Told {
    EnergyReport report;
    std::vector<PowerStep> steps;
    Bill bill;
};

Told told(const Stream& stream, Kinematics kinematics, double step, const Tariff& tariff,
          double start) {
    Told told;
    Printer printer;
    printer.kinematics = kinematics;
    printer.delta = {.arm = 4000, .radius = 2000, .head_mass = 0.3};
    printer.filament = thin;
    printer.power = bed_slinger();
    PowerCurve curve(step, [&](const PowerStep& s) { told.steps.push_back(s); });
    Billing billing(tariff, start);
    EnergyMeter meter(printer, plain);
    meter.listen(
        {[&](double time) { return std::min(curve.end_of_step(time), billing.next_change(time)); },
         [&](const PowerPiece& piece) {
             curve.add(piece);
             billing.add(piece);
         }});
    for (const MotionEvent& event : stream) meter.add(event);
    curve.finish();
    told.report = meter.report();
    told.bill = billing.bill();
    return told;
}

RC_GTEST_PROP(EnergyLaws, TheCurvesIntegralIsTheTotal, ()) {
    const Stream stream = any_print();
    const double step = number_between(0.2, 20);
    for (const Kinematics kinematics : {Kinematics::cartesian, Kinematics::corexy}) {
        const Told t = told(stream, kinematics, step, {{0, day, 1}}, 0);
        Energy sum;
        for (const PowerStep& s : t.steps) sum += step * s.power;
        RC_ASSERT(near(total(sum), total(t.report.energy)));
        RC_ASSERT(near(sum.motors, t.report.energy.motors));
        RC_ASSERT(near(sum.bed, t.report.energy.bed));
        const double seconds = t.report.duration + t.report.heat_up_duration;
        RC_ASSERT(std::abs(double(t.steps.size()) - std::ceil(seconds / step)) <= 1);
        for (const PowerStep& s : t.steps)
            RC_ASSERT(total(s.power) <= t.report.peak_power * (1 + 1e-9));
    }
}

RC_GTEST_PROP(EnergyLaws, ListeningChangesNothing, ()) {
    const Stream stream = any_print();
    PowerModel strong = bed_slinger();
    const EnergyReport alone = measured(stream, strong);
    const Told heard =
        told(stream, Kinematics::cartesian, number_between(0.2, 20), {{0, day, 1}}, 0);
    RC_ASSERT(near(total(alone.energy), total(heard.report.energy)));
    RC_ASSERT(near(alone.heat_up, heard.report.heat_up));
    RC_ASSERT(near(alone.energy.motors, heard.report.energy.motors));
}

RC_GTEST_PROP(EnergyLaws, ATariffOfOnePriceIsThePriceOfTheTotal, ()) {
    const Stream stream = any_print();
    const double start = number_between(0, day), change = number_between(1, day - 1);
    const Told one = told(stream, Kinematics::cartesian, 7, {{0, day, 0.3}}, start);
    const Told two =
        told(stream, Kinematics::cartesian, 7, {{0, change, 0.3}, {change, day, 0.3}}, start);
    const double price = 0.3 * total(one.report.energy) / joules_per_kwh;
    for (const Bill& bill : {one.bill, two.bill}) RC_ASSERT(near(bill.heat_up + bill.print, price));
    RC_ASSERT(near(two.bill.energy[0] + two.bill.energy[1], one.bill.energy[0]));
}

TEST(Standstill, SavesAfterItsDelayUntilTheMotorTurns) {
    PowerModel power;
    power.motors[axis_x] = {.standing = 2, .holding = 0.5};
    power.standstill_delay = 0.6;
    const Block move = trapezoid({100, 0, 0, 0}, 0, 0, 80, 1000);
    const EnergyReport r = measured({Dwell{1}, move, Dwell{0.4}, Dwell{0.4}}, power);
    EXPECT_NEAR(r.energy.motors, 2 * (1.8 + duration(move)) - 1.5 * (0.4 + 0.2), 1e-12);
}

TEST(Standstill, OfBothMotorsOfACoreXYIsTheirOwn) {
    Printer printer;
    printer.kinematics = Kinematics::corexy;
    printer.power = PowerModel{};
    for (Motor& motor : printer.power.motors) motor = {};
    printer.power.motors[0] = printer.power.motors[1] = {.standing = 2, .holding = 0};
    const Block diagonal = trapezoid({50, 50, 0, 0}, 0, 0, 80, 1000);  // one of them stands
    EnergyMeter meter(printer, plain);
    meter.add(diagonal);
    EXPECT_NEAR(meter.report().energy.motors, 2 * duration(diagonal), 1e-12);
}

TEST(BedMass, GrowsByWhatIsPrinted) {
    PowerModel power;
    power.motors[axis_y] = {.moving_mass = 1};
    power.bed_axis = axis_y;
    const Block lay = trapezoid({0, 0, 0, 1000}, 0, 0, 80, 1000);
    const Block move = trapezoid({0, 100, 0, 0}, 0, 0, 100, 1000);
    const double grams = pi / 4 * thin * thin * 1000 * 1.25e-3;
    const double bare = measured({move}, power).energy.motors;
    const double laden = measured({lay, move}, power).energy.motors;
    EXPECT_NEAR(laden / bare, 1 + grams * 1e-3, 1e-12);
}

}  // namespace
}  // namespace bead
