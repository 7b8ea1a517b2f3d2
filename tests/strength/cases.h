// Small load cases with known answers.
#pragma once
#include "fem/load_case.h"
#include "toolpath/path.h"

namespace bead {

inline Region box_region(double width, double height) {
    return {{{{0, 0}, {width, 0}, {width, height}, {0, height}}, {}}};
}

// A bar of `size`, held at its left end, with a force at its right end.
inline LoadCase bar_case(Vec2 size, Vec2 force) {
    LoadCase bar;
    bar.title = "bar";
    bar.thickness = 1.2;
    bar.part = box_region(size.x, size.y);
    bar.situations.resize(1);
    bar.situations[0].supports.push_back({{{0, 0}, {0, size.y}, {}}, true, true});
    Load load;
    load.on = {{size.x, 0}, {size.x, size.y}, {}};
    load.force = force;
    bar.situations[0].loads.push_back(load);
    return bar;
}

// Beads side by side along the bar, 0.6 mm wide and high: as a rectangle it is solid.
inline Bead straight_bead() { return {0.6 + (1 - pi / 4) * 0.6, 0.6}; }
inline Toolpath solid_bar(Vec2 size) {
    Toolpath layer;
    for (double y = 0.3; y < size.y; y += 0.6) {
        Path path;
        path.role = Role::infill;
        path.bead = straight_bead();
        path.points = {{0, y, 0}, {size.x, y, 0}};
        layer.push_back(path);
    }
    return layer;
}

}  // namespace bead
