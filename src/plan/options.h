// How a part is built up, whatever the printer: walls, solid layers, infill, beads, speeds.
// Defaults are those of an ordinary 0.4 mm nozzle with 0.2 mm layers. Lengths mm, speeds mm/s,
// angles rad.
#pragma once
#include "infill/fill.h"

namespace bead {

struct Speeds {
    double outer_wall = 30;
    double wall = 60;
    double skin = 60;
    double top_skin = 40;
    double infill = 80;
    double skirt = 30;
    double first_layer = 30;  // everything that is printed on the first layer
    double travel = 130;
    double over_infill = 0;  // skin that is laid on sparse infill; 0: as other skin
};

struct PlanOptions {
    int walls = 2;
    int top_layers = 4;
    int bottom_layers = 4;
    double density = 0.2;  // 0 … 1, deposited volume / volume between the walls
    NamedPattern pattern = patterns[0];
    bool pattern_on_bottom = false;  // skin that nothing lies below has the pattern too
    double angle = pi / 4;           // of even layers; directed patterns turn by 90° on odd ones
    double bead_width = 0.45;
    double first_layer_width = 0.45;
    double top_skin_width = 0;     // 0: bead_width
    double over_infill_width = 0;  // of skin that is laid on sparse infill; 0: bead_width
    double infill_overlap = 0.25;  // of a bead's width by which sparse infill reaches into a wall
    Speeds speeds;
    double first_layer_acceleration = 0;  // mm/s²; 0: the printer's usual
    double over_infill_acceleration = 0;
    int skirt_loops = 1;
    double skirt_gap = 4;
    double retract_before_travel = 2;  // shorter travel keeps its filament where it is
    int threads = 0;
};

}  // namespace bead
