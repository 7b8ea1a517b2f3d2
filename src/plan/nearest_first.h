// A few things in an order in which the way from each to the next is short.
#pragma once
#include <algorithm>
#include <vector>

#include "geom/vec.h"

namespace bead {

// Always on to the nearest that is left; `point_of(thing)` is where it is. Takes time by the square
// of their number.
template <class Thing, class PointOf>
std::vector<Thing> nearest_first(std::vector<Thing> things, Vec2 start, const PointOf& point_of) {
    for (auto next = things.begin(); next != things.end(); ++next) {
        const auto nearest = std::ranges::min_element(
            next, things.end(), {},
            [&](const Thing& thing) { return distance(start, point_of(thing)); });
        std::iter_swap(next, nearest);
        start = point_of(*next);
    }
    return things;
}

}  // namespace bead
