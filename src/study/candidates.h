// The ways to fill a layer that are tried, and what each costs on each kind of layer.
#pragma once
#include "study/layer_cost.h"

namespace bead {

struct Effort {
    long candidates = 0;  // combinations of rotation, pattern and angle
    long evaluated = 0;   // layers planned and simulated
};

// 0, step, 2 step … below `end`, with the step made to fit.
std::vector<double> steps_up_to(double end, double step);

// Every pattern at every angle.
std::vector<FillChoice> all_choices(std::span<const NamedPattern> allowed, double angle_step);

// Angle between two families of lines, 0 … pi/2.
double crossing(double a, double b);

// One row per class, one column per choice; infinite where another choice gives the same.
using CostTable = std::vector<std::vector<double>>;
CostTable class_costs(std::span<const LayerParts> parts, std::span<const LayerClass> classes,
                      std::span<const FillChoice> choices, const Jury& jury, int threads,
                      Effort& effort);

}  // namespace bead
