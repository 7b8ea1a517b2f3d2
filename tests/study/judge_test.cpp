#include "study/judge.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "study/print.h"

namespace bead {
namespace {

Machine a_delta() {
    Machine machine;
    machine.printer.kinematics = Kinematics::delta;
    machine.printer.delta = {.arm = 300, .radius = 160, .head_mass = 0.3};
    machine.printer.bed = {220, 220, 300};
    machine.printer.power.supply_efficiency = 1;
    for (Motor& motor : machine.printer.power.motors) motor.per_speed = 0.05;
    return machine;
}

Command move_to(double x, double y) {
    Move move;
    move.to = {x, y, 0, 0};
    move.feed = 60;
    return {move};
}

SetPosition here(double x, double y) {
    SetPosition position;
    position.to[axis_x] = x;
    position.to[axis_y] = y;
    return position;
}

double joules(const std::vector<Command>& commands) {
    Judge judge(a_delta());
    for (const Command& command : commands) judge.add(command);
    return judge.finish().energy.energy.motors;
}

// What a move away from (x, y) and back draws.
double there_and_back(double x, double y) {
    return joules({{here(x, y)}, move_to(x + 20, y), move_to(x, y)});
}

TEST(Judge, BelievesWhereADeltaStarts) {
    EXPECT_GT(std::abs(there_and_back(60, 0) - there_and_back(0, 0)), 0.01 * there_and_back(0, 0));
}

TEST(Judge, KnowsThatALaterG92MovesNothing) {
    const double plain = joules({move_to(40, 0), {Drain{}}, move_to(60, 0)});
    EXPECT_NEAR(joules({move_to(40, 0), {here(0, 0)}, move_to(20, 0)}), plain, 1e-6);
}

TEST(Judge, FindsADeltaInTheMiddleAfterHoming) {
    const double out = joules({move_to(40, 0)}), on = joules({move_to(20, 0)});
    EXPECT_NEAR(joules({move_to(40, 0), {Home{}}, move_to(20, 0)}), out + on, 1e-6);
}

TEST(Judge, RefusesAFileThatIsNotForADelta) { EXPECT_THROW(joules({move_to(200, 200)}), Error); }

TEST(Print, StandsInTheMiddleOfARoundBed) {
    LayerParts layer;
    const Polyline square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    layer.islands.emplace_back().outline = {square, {}};
    const Printer printer = a_delta().printer;
    const std::vector<LayerParts> placed = on_bed({&layer, 1}, 0, printer);
    EXPECT_EQ(placed[0].islands[0].outline.outer[2], (Vec2{50, 50}));
    EXPECT_TRUE(fits_bed(placed, printer));
    Printer small = printer;
    small.bed[0] = 140;  // the square's diagonal is 141.4
    EXPECT_FALSE(fits_bed(placed, small));
}

}  // namespace
}  // namespace bead
