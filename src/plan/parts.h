// What a layer is made of before any pattern or angle is chosen: wall loops, solid skin, sparse
// infill. It is computed once; turning the part turns it, choosing a pattern reads it.
//
// Walls lie at `spacing(bead)` from each other, the outer one half a bead's width inside the
// outline, so that with stadium beads wall, skin and infill fill the plane without gap or overlap.
// Skin is what the next `top_layers` or the previous `bottom_layers` leave uncovered.
#pragma once
#include <span>
#include <vector>

#include "plan/options.h"
#include "slice/slice.h"
#include "toolpath/path.h"

namespace bead {

struct WallLoop {
    Role role = Role::wall;  // outer_wall or wall
    Polyline points;         // closed, first point not repeated, starting at the seam
};

// All of an island's sparse infill is one area; every connected piece of its skin is one.
struct FillArea {
    Role role = Role::infill;  // skin, top_skin or infill
    Region material;           // what is to be filled
    Region centre;             // where centre lines may run
    Bead bead = {};
    bool on_infill = false;  // skin on the sparse infill of the layer below
    bool patterned = false;  // skin that is to have the pattern of the infill
};

// One connected piece of a layer.
struct Island {
    Polygon outline;
    std::vector<WallLoop> walls;  // in printing order: inner before outer
    std::vector<FillArea> fills;
};

struct LayerParts {
    double z = 0, height = 0;  // mm; z is the top of the layer
    int index = 0;             // from 0
    Bead bead;                 // of everything in this layer but, where asked for, its skin
    std::vector<Island> islands;
    std::vector<Polyline> skirt;  // closed loops; first layer only
    Vec2 centre;  // middle of the box round all layers: infill is laid out from here
};

// Each loop starts at its sharpest corner, of corners about as sharp at the rearmost (largest y),
// as the part lies in `layers`: `moved` takes the seam along.
std::vector<LayerParts> parts_of(std::span<const Layer> layers, const PlanOptions& options);

// Turned by `angle` (rad) about the vertical through `about`, then moved by `shift`.
LayerParts moved(LayerParts parts, double angle, Vec2 about, Vec2 shift);

}  // namespace bead
