// The ways to fill a layer that are tried, and what each costs on each kind of layer.
#pragma once
#include "study/layer_cost.h"

namespace bead {

// What plastic is worth when candidates of different weight are compared: without it, the cheapest
// way to fill a layer would be the one that fills it least.
struct Weights {
    double per_filament = 0;  // cost per mm of the baseline's filament
    double filament = 0;      // mm, of the whole baseline
};

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
using CostTable = std::vector<std::vector<LayerCost>>;
CostTable class_costs(std::span<const LayerParts> parts, std::span<const LayerClass> classes,
                      std::span<const FillChoice> choices, const Jury& jury, int threads,
                      Effort& effort);

}  // namespace bead
