// How long each axis speeds up, coasts, slows down and stands still, and how far it goes: what the
// energy of motors is usually reckoned from. All axes of a block share its times, so for every axis
// accelerate + coast + decelerate + hold = the whole duration.
#pragma once
#include "motion/block.h"

namespace bead {

struct AxisTimes {
    double accelerate = 0, coast = 0, decelerate = 0, hold = 0;  // s
    double distance = 0;                                         // mm, back and forth added up
};

void add(PerAxis<AxisTimes>& times, const Block& block);
void add(PerAxis<AxisTimes>& times, const Dwell& dwell);

}  // namespace bead
