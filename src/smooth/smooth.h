// One layer's toolpath to one that lays the same beads and shakes the machine less.
//
// Stages, each of which may be left out: loops cleaned of needless points; curves found again in
// polygons; nested loops wound into one stroke; the strokes put in an order and given seams for
// which the travel between them, of arcs and straight lines, is short; corners rounded within a
// tolerance; chords as long as a tolerance and the machine's modes allow. Every stroke deposits
// exactly what its loops did. docs/smoothing.md.
//
//     const SmoothedLayer after = smoothed(layer, {.modes = {14, 22}});
#pragma once
#include <array>
#include <optional>

#include "geom/vec.h"
#include "smooth/velocity_step.h"
#include "toolpath/path.h"

namespace bead {

struct SmoothTolerances {                                 // mm
    double outer_wall = 0.05, wall = 0.10, infill = 1.0;  // between a corner and what rounds it
    // The radius of travel's turns at its ends: at right angles it leaves the straight way by that.
    // Over short ways it is less (travel.h).
    double travel = 4.0;
};

struct SmoothStages {
    bool clean = true, curves = true, chains = true, order = true, blends = true, chords = true;
    bool seams = true;  // loops are begun where travel is short, else where they were
    bool bead_plan = false, thinning = false;
};

struct SmoothOptions {
    SmoothTolerances tolerances;
    SmoothStages stages;
    std::array<double, 2> modes{14, 22};  // Hz, of X and Y
    double acceleration = 1000;           // mm/s², across a bend
    double point_budget = 1.2;            // the layer's points may grow by this factor
    double link = 3;                      // mm, from one nested loop to the next
    Vec2 start{};                         // where the nozzle is before the layer
    // mm of travel that pulling filament back takes as long as; 0: travel does not stop for it.
    double retraction = 0;
    std::optional<VelocityStep> step;  // of the firmware that will run it, where that is known
};

struct SmoothedLayer {
    Toolpath path;  // travel included; one path per constant role, bead and speed
    int chains = 0, links = 0, arcs = 0, blends = 0;
    int kept = 0;  // strokes left as they were since a tolerance could not be kept
};

// A layer without anything deposited comes back as it is, and so does one that would need more
// points than the budget has.
SmoothedLayer smoothed(const Toolpath& layer, const SmoothOptions& options = {});

}  // namespace bead
