// A layout printed layer on layer: what carries tension first, then compression, braces and
// patches, then pads and walls (Sales 2019 measured 16 % more strength for tension first); odd
// layers begin with compression, unless it is laid thinner where it crosses (crossing_flow.h).
#pragma once
#include "plan/options.h"
#include "plan/program.h"
#include "study/layout.h"
#include "study/print.h"

namespace bead {

struct LayeredLayout {
    Layout layout;
    LoadCase load_case;
    int layers = 1;
    Vec2 shift;  // mm, to its place on the bed
};

// The layers' toolpaths, one after another, `start`: where the nozzle is before the first.
std::vector<Toolpath> toolpaths(const LayeredLayout& print, const PlanOptions& options, Vec2 start);

// From heating to switching off.
void run(const LayeredLayout& print, const PlanOptions& options, const ProgramOptions& program,
         const CommandSink& sink);

}  // namespace bead
