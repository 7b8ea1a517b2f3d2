#include "study/optimize.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "study/layer_cost.h"
#include "support/shapes.h"

namespace bead {
namespace {

// A machine with every consumer on, not one in particular.
Machine test_machine() {
    Machine machine;
    PowerModel& power = machine.printer.power;
    power.electronics = 10;
    power.part_fan = 2;
    power.supply_efficiency = 0.9;
    for (Motor& motor : power.motors) motor = {1, 0.01, 2, 0.5, 0.8};
    power.hotend = {40, 12, 20, 10};
    power.bed = {200, 500, 0.8};
    return machine;
}

PlanOptions thin_plan() {
    PlanOptions plan;
    plan.top_layers = plan.bottom_layers = 1;
    return plan;
}

std::vector<LayerParts> plate_parts(const PlanOptions& plan) {
    const Mesh mesh = shapes::box({60, 15, 1.6});
    return parts_of(slice(mesh, {}).layers, plan);
}

double crossing(double a, double b) {
    const double turn = std::fmod(std::abs(a - b), pi);
    return std::min(turn, pi - turn);
}

TEST(Optimize, IsNeverWorseThanItsBaseline) {
    const PlanOptions plan = thin_plan();
    const std::vector<LayerParts> parts = plate_parts(plan);
    for (const Goal goal : {Goal::machine_energy, Goal::xy_energy, Goal::time}) {
        OptimizeOptions options;
        options.goal = goal;
        options.angle_step = options.rotation_step = pi / 4;
        const Optimum best = optimize(parts, plan, {}, test_machine(), options);
        EXPECT_LE(value_of(goal, best.chosen.cost), value_of(goal, best.baseline.cost));
        EXPECT_GT(best.evaluated, 0);
        EXPECT_EQ(best.chosen.print.choices.size(), parts.size());
    }
}

TEST(Optimize, FindsThatLongLinesAreFaster) {
    // A bar of 60 x 15 mm with lines along X in every layer: fewer turns than across. With only
    // rectilinear to choose from and no rotation, time decides for the angles, and layers cross.
    const PlanOptions plan = thin_plan();
    const std::vector<LayerParts> parts = plate_parts(plan);
    OptimizeOptions options;
    options.goal = Goal::time;
    options.rotation = 0;
    options.patterns = {patterns[0]};
    const Optimum best = optimize(parts, plan, {}, test_machine(), options);
    EXPECT_LT(best.chosen.cost.motion.duration, best.baseline.cost.motion.duration);
    for (std::size_t i = 1; i < best.chosen.print.choices.size(); ++i)
        EXPECT_GE(
            crossing(best.chosen.print.choices[i].angle, best.chosen.print.choices[i - 1].angle),
            options.least_crossing - 1e-6);
}

TEST(Optimize, KeepsTheWeight) {
    const PlanOptions plan = thin_plan();
    const std::vector<LayerParts> parts = plate_parts(plan);
    OptimizeOptions options;
    options.angle_step = pi / 4;
    const Optimum best = optimize(parts, plan, {}, test_machine(), options);
    EXPECT_GE(best.chosen.cost.motion.extruded, 0.995 * best.baseline.cost.motion.extruded);
}

// Tilting the lines by two degrees must not seem to save energy, whatever the published model says.
TEST(Optimize, DoesNotGoThroughTheHoldLoophole) {
    PlanOptions plan = thin_plan();
    plan.walls = 0;
    plan.density = 1;
    const Machine machine = test_machine();
    const std::vector<LayerParts> parts = on_bed(plate_parts(plan), 0, machine.printer);
    const FillSpacing lines = matched_spacing(parts, plan);
    const ProgramOptions program;
    for (const Goal goal : {Goal::machine_energy, Goal::xy_energy}) {
        const Jury jury{machine, plan, program, lines, goal};
        const double straight = layer_cost(parts[3], {patterns[0], 0}, jury);
        const double tilted = layer_cost(parts[3], {patterns[0], 2 * pi / 180}, jury);
        EXPECT_GT(tilted, 0.99 * straight);
    }
}

TEST(Optimize, JudgesAlikeLayersOnce) {
    const std::vector<LayerParts> parts = plate_parts(thin_plan());
    const std::vector<LayerClass> classes = alike_layers(parts);
    EXPECT_EQ(parts.size(), 8U);
    EXPECT_EQ(classes.size(), 3U);  // bottom, middle, top
    std::size_t members = 0;
    for (const LayerClass& one : classes) members += one.members.size();
    EXPECT_EQ(members, parts.size());
}

TEST(Optimize, CopesWithNothingToChoose) {
    PlanOptions plan;
    plan.top_layers = plan.bottom_layers = 0;
    plan.density = 0;
    OptimizeOptions options;
    options.patterns = {patterns[2]};
    options.angle_step = options.rotation_step = pi / 4;
    const Optimum best = optimize(plate_parts(plan), plan, {}, test_machine(), options);
    EXPECT_LE(best.chosen.cost.motion.duration, best.baseline.cost.motion.duration);
}

TEST(Optimize, RefusesAPartThatCannotFit) {
    const PlanOptions plan = thin_plan();
    Machine machine = test_machine();
    machine.printer.bed = {40, 40, 100};
    EXPECT_THROW(optimize(plate_parts(plan), plan, {}, machine, {}), Error);
}

}  // namespace
}  // namespace bead
