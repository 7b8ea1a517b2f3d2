// Small load cases for designs.
#pragma once
#include "fem/load_case.h"

namespace bead {

inline Region box_part(Vec2 size) {
    return {{{{0, 0}, {size.x, 0}, {size.x, size.y}, {0, size.y}}, {}}};
}

inline Load pull(Vec2 from, Vec2 to, Vec2 force) {
    Load load;
    load.on = {from, to, {}};
    load.force = force;
    return load;
}

// Held at its left end, loaded at its right one; of ABS, 40 % of it deposited.
inline LoadCase cantilever_case(Vec2 size, Vec2 force = {0, -20}) {
    LoadCase result;
    result.thickness = 6;
    result.part = box_part(size);
    result.situations.resize(1);
    result.situations[0].supports.push_back({{{0, 0}, {0, size.y}, {}}, true, true});
    result.situations[0].loads.push_back(pull({size.x, 0}, size, force));
    return result;
}

// Lies on its lower corners, pressed in the middle from above.
inline LoadCase beam_case(Vec2 size) {
    LoadCase result;
    result.thickness = 6;
    result.part = box_part(size);
    Situation& s = result.situations.emplace_back();
    s.supports.push_back({{{0, 0}, {3, 0}, {}}, false, true});
    s.supports.push_back({{{size.x - 3, 0}, {size.x, 0}, {}}, false, true});
    s.supports.push_back({{{0, 0}, {0, 0}, {}}, true, false});
    s.loads.push_back(pull({size.x / 2 - 2, size.y}, {size.x / 2 + 2, size.y}, {0, -20}));
    return result;
}

}  // namespace bead
