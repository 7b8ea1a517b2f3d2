#include "measure.h"

#include "geom/clip.h"
#include "infill/fill.h"
#include "job/material_file.h"
#include "job/printer_file.h"

namespace bead::angles {
namespace {

constexpr double side = 40, bead_width = 0.45, bead_height = 0.2;  // mm

Region region_of(Shape shape, Vec2 middle) {
    Polyline outline;
    const int corners = shape == Shape::square ? 4 : 720;
    const double radius = shape == Shape::square ? side / std::sqrt(2) : side / std::sqrt(pi);
    for (int i = 0; i < corners; ++i)
        outline.push_back(middle + radius * unit(2 * pi * (i + 0.5) / corners));
    return offset({{outline, {}}}, -bead_width / 2);
}

std::vector<Command> commands_for(const Rig& rig, const Task& task, double& length) {
    const Vec2 middle = middle_of_bed(rig.printer);
    const double filament = pi / 4 * rig.printer.filament * rig.printer.filament;
    std::vector<Command> commands;
    Move move;
    for (const Polyline& line :
         rectilinear(region_of(task.shape, middle),
                     {.spacing = task.spacing, .angle = task.angle, .centre = middle})) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const double step = i > 0 ? distance(line[i - 1], line[i]) : 0;
            move.to[axis_x] = line[i].x;
            move.to[axis_y] = line[i].y;
            move.to[axis_e] += step * bead_width * bead_height / filament;
            move.feed = i > 0 ? task.speed : 2 * task.speed;
            move.role = i > 0 ? Role::infill : Role::travel;
            commands.push_back({move});
            length += step;
        }
    }
    return commands;
}

// To a CoreXY's motors and, being a reflection, back: A and B are its X and Y times √2.
template <class Place>
void reflect(Place& place) {
    const double x = place[axis_x], y = place[axis_y];
    place[axis_x] = (x + y) / std::sqrt(2);
    place[axis_y] = (x - y) / std::sqrt(2);
}

// Limits of motors, told in the reflected axes.
Limits reflected(Limits limits) {
    for (const Axis axis : {axis_x, axis_y}) {
        limits.max_feedrate[axis] /= std::sqrt(2);
        limits.max_acceleration[axis] /= std::sqrt(2);
        limits.jerk[axis] /= std::sqrt(2);
        limits.steps_per_mm[axis] *= std::sqrt(2);
    }
    return limits;
}

// The head comes from where the first line starts.
void run(const Rig& rig, std::vector<Command> commands, EnergyMeter& meter) {
    const bool reflects = rig.limits_motors;
    const auto planner = make_planner(reflects ? reflected(rig.printer.limits) : rig.printer.limits,
                                      rig.planner, [&](const MotionEvent& event) {
                                          MotionEvent heard = event;
                                          Block* block = std::get_if<Block>(&heard);
                                          if (block && reflects) reflect(block->delta);
                                          meter.add(heard);
                                      });
    const Position first = std::get<Move>(commands.front().what).to;
    meter.place({first[axis_x], first[axis_y]});
    if (reflects)
        for (Command& command : commands) reflect(std::get<Move>(command.what).to);
    SetPosition start;
    for (const Axis axis : {axis_x, axis_y})
        start.to[axis] = std::get<Move>(commands.front().what).to[axis];
    planner->add({start});
    for (const Command& command : commands) planner->add(command);
    planner->finish();
}

}  // namespace

std::vector<Rig> rigs() {
    const Material pla = load_material("pla");
    const Printer mk3 = load_printer("prusa-mk3s"), voron = load_printer("voron-corexy"),
                  kossel = load_printer("kossel");
    Printer free_mk3 = mk3;
    free_mk3.limits.acceleration = free_mk3.limits.travel_acceleration = 1e4;
    return {{"MK3S, Prusa", mk3, pla, {Firmware::prusa}, false},
            {"MK3S, only axes limited", free_mk3, pla, {Firmware::prusa}, false},
            {"MK3S, Klipper", mk3, pla, {Firmware::klipper}, false},
            {"Voron, Klipper", voron, pla, {Firmware::klipper}, false},
            {"Voron, Marlin", voron, pla, {Firmware::marlin_jerk}, true},
            {"Kossel, Klipper", kossel, pla, {Firmware::klipper}, false}};
}

Cost measured(const Rig& rig, const Task& task) {
    Cost cost;
    const std::vector<Command> commands = commands_for(rig, task, cost.length);
    EnergyMeter meter(rig.printer, rig.material);
    meter.add(SetHeat{Heater::bed, rig.material.bed, true});
    meter.add(SetHeat{Heater::hotend, rig.material.hotend, true});
    meter.add(SetFan{1});
    const EnergyReport warm = meter.report();
    run(rig, commands, meter);
    const EnergyReport done = meter.report();
    cost.time = done.duration - warm.duration;
    cost.head = done.xy_motors - warm.xy_motors;
    cost.energy = done.energy - warm.energy;
    return cost;
}

}  // namespace bead::angles
