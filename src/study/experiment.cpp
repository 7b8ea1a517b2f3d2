#include "study/experiment.h"

#include <cmath>

namespace bead {
namespace {

Region rectangle(double width, double depth) {
    const double x = width / 2, y = depth / 2;
    return {{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, {}}};
}

// One corner on +X.
Region equilateral(double side) {
    const double far = side / std::sqrt(3);  // from the middle to a corner
    return {{{{far, 0}, {-far / 2, side / 2}, {-far / 2, -side / 2}}, {}}};
}

Region ellipse(double width, double depth) {
    constexpr int corners = 180;
    Polyline loop;
    for (int i = 0; i < corners; ++i) {
        const Vec2 p = unit(2 * pi * i / corners);
        loop.push_back({width / 2 * p.x, depth / 2 * p.y});
    }
    return {{std::move(loop), {}}};
}

// A circle and the two tangents from a point on +X, `tip` from its centre.
Region drop(double radius, double tip) {
    constexpr int chords = 180;
    const double touch = std::acos(radius / tip);
    Polyline loop{{tip, 0}};
    for (int i = 0; i <= chords; ++i)
        loop.push_back(radius * unit(touch + (2 * pi - 2 * touch) * i / chords));
    return {{std::move(loop), {}}};
}

std::vector<Layer> layers_of(const Region& outline) {
    constexpr double first = 0.2, height = 0.1;
    constexpr int count = 20;
    std::vector<Layer> layers;
    layers.reserve(count);
    for (int i = 0; i < count; ++i)
        layers.push_back({first + i * height, i == 0 ? first : height, outline});
    return layers;
}

Speeds speeds_of(const ExperimentSetup& setup) {
    Speeds speeds;
    speeds.infill = speeds.skin = 80;
    speeds.top_skin = 40;
    speeds.first_layer = speeds.over_infill = 20;
    speeds.travel = 180;
    if (setup.speed > 0)
        speeds.infill = speeds.skin = speeds.top_skin = speeds.first_layer = speeds.over_infill =
            setup.speed;
    return speeds;
}

// PrusaSlicer 2.5's bundled "0.10mm DETAIL @MK3" without perimeters and skirt, at 20 %, where the
// pattern was chosen for the bottom too: its list for solid layers has these five and no others.
PlanOptions plan_of(const ExperimentSetup& setup) {
    PlanOptions plan;
    plan.walls = plan.skirt_loops = 0;
    plan.bottom_layers = 7;
    plan.top_layers = 9;
    plan.density = 0.2;
    plan.pattern_on_bottom = true;
    plan.pattern = setup.pattern;
    plan.angle = setup.infill_angle;
    plan.bead_width = 0.45;
    plan.first_layer_width = 0.42;
    plan.top_skin_width = 0.40;
    plan.over_infill_width = 0.4715;  // lines 0.45 apart: threads of the nozzle's 0.4 and a gap
    plan.speeds = speeds_of(setup);
    plan.first_layer_acceleration = plan.over_infill_acceleration = 800;
    plan.threads = 1;
    return plan;
}

ProgramOptions program_of(const Machine& machine) {
    ProgramOptions program;
    program.limits.acceleration = machine.printer.limits.acceleration;
    program.highest = machine.printer.bed[2];
    return program;
}

double radians(int degrees) { return degrees * pi / 180; }

}  // namespace

std::vector<ExperimentRun> experiment_runs() {
    std::vector<ExperimentRun> runs;
    for (std::size_t shape = 0; shape < shape_names.size(); ++shape)
        for (std::size_t pattern = 0; pattern < experiment_patterns; ++pattern)
            for (const int infill : infill_angles)
                for (const int part : part_angles)
                    runs.push_back({static_cast<Shape>(shape), pattern, infill, part});
    return runs;
}

Region outline_of(Shape shape) {
    switch (shape) {
        case Shape::square:
            return rectangle(53.9, 53.9);
        case Shape::rectangle:
            return rectangle(81, 26.8);
        case Shape::triangle:
            return equilateral(53.1);
        case Shape::drop:
            return drop(25.8, 45.5);
        case Shape::oval:
            return ellipse(72.7, 60.3);
    }
    return {};
}

ExperimentSetup setup_of(const ExperimentRun& run) {
    return {patterns.at(run.pattern), radians(run.infill_angle), radians(run.part_angle)};
}

Print experiment_print(const Region& outline, const ExperimentSetup& setup) {
    const Machine machine = experiment_machine();
    Print print;
    print.plan = plan_of(setup);
    print.parts =
        on_bed(parts_of(layers_of(outline), print.plan), setup.part_angle, machine.printer);
    print.choices = uniform_choices(print.parts.size(), print.plan);
    print.program = program_of(machine);
    return print;
}

Machine experiment_machine(Machine machine) {
    Limits& limits = machine.printer.limits;
    limits.max_feedrate = {200, 200, 12, 120};
    limits.max_acceleration = {1000, 1000, 1000, 5000};
    limits.acceleration = limits.retract_acceleration = limits.travel_acceleration = 1000;
    limits.jerk = {8, 8, 0.4, 4.5};
    return machine;
}

Assessment judged(const Print& print, const Machine& machine, Judging judging) {
    Judge judge(machine, {}, judging);
    run(print, [&](const Command& command) { judge.add(command); });
    return judge.finish();
}

}  // namespace bead
