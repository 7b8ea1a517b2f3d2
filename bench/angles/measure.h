// One layer of lines at an angle, on a machine that is warm: how long it takes and what it draws.
#pragma once
#include <string>
#include <vector>

#include "energy/meter.h"
#include "motion/planner.h"

namespace bead::angles {

struct Rig {
    std::string name;
    Printer printer;
    Material material;
    PlannerOptions planner;
    bool limits_motors = false;  // of a CoreXY, as Marlin has it; else limits are the head's
};
std::vector<Rig> rigs();

enum class Shape { square, disc };  // 40 x 40 mm, and as much area
struct Task {
    Shape shape = Shape::square;
    double spacing = 0.45;  // mm
    double speed = 100;     // mm/s
    double angle = 0;       // rad
};

// Of the whole layer.
struct Cost {
    double length = 0;  // mm of line
    double time = 0;    // s
    double head = 0;    // J, motors that move X and Y, standing included
    Energy energy;      // J
};
Cost measured(const Rig& rig, const Task& task);

}  // namespace bead::angles
