// Joins open lines where the end of one is near the start of another (or its own), nearest first.
#pragma once
#include <vector>

#include "geom/polygon.h"

namespace bead {

struct Joined {
    std::vector<Polyline> loops;
    std::vector<Polyline> open;  // what no partner was found for
};

// Ends farther apart than `gap` (mm) are not joined. A line closes on itself only over less than
// half its own length, else every short scrap would become a loop.
Joined joined(const std::vector<Polyline>& lines, double gap);

}  // namespace bead
