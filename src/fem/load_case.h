// One load case of a 2.5D part, as plain structs: an outline of one thickness, what holds it, what
// pulls at it, and how it is to be printed. What a CASE.toml says; job/case_file.h reads it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "geom/polygon.h"

namespace bead {

struct SolidMaterial {
    double young = 2200;  // MPa
    double poisson = 0.35;
    double tensile = 35;      // MPa, strength
    double compressive = 52;  // MPa, strength, positive
    double density = 1.04;    // g/cm³
    // What is printed over what it becomes: metal filament shrinks when it is sintered.
    double green_plane = 1, green_height = 1;
};

struct Circle {
    Vec2 centre;
    double radius = 0;  // mm
};

// A piece of the part's boundary: from one point of it to another, the shorter way round; or, with
// an arc, all of the boundary that lies on the circle between two angles (rad, counter-clockwise
// from `begin` to `end`). `from` equal to `to` is a single point, which can hold but not be loaded.
struct CircleArc {
    Circle circle;
    double begin = 0, end = 2 * pi;
};
struct Stretch {
    Vec2 from, to;
    std::optional<CircleArc> arc;
};

struct Support {
    Stretch on;
    bool x = true, y = true;  // displacements that are held at 0
};

struct Load {
    Stretch on;
    Vec2 force{};          // N, the resultant; spread evenly
    bool bearing = false;  // instead: in proportion to the cosine of the angle from the force
    double turn = 0;       // rad, the load may turn by this much either way
    double move = 0;       // mm, and slide along the boundary by this much either way
};

// Supports and loads that act together.
struct Situation {
    double weight = 1;
    std::vector<Support> supports;
    std::vector<Load> loads;
};

struct PrintHeat {
    double hotend = 0, hotend_first = 0, bed = 0;  // °C
};

// A bead counts as a rectangle of its width and height, whose section the printed one has.
struct PrintWish {
    double bead_width = 0.6, layer_height = 0.6;  // mm
    double fill = 0.4;  // deposited volume / solid volume, walls and pads included
    int walls = 1;
    double crossing_flow = 1;         // share of its section with which a bead crosses another
    std::optional<PrintHeat> heat{};  // where the case names or tells it
};

struct LoadCase {
    std::string title;
    double thickness = 1;         // mm
    std::optional<bool> guided;   // kept in its plane, as between plates; nothing: not said
    Region part;                  // round holes as polygons within a few µm
    std::vector<Circle> circles;  // those of them that are round; meshes with curved sides use them
    SolidMaterial material;
    std::vector<Situation> situations;  // at least one
    std::vector<Vec2> probes;
    PrintWish print;
};

}  // namespace bead
