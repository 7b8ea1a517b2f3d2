// How sure an energy is: the range that holds the true value in 95 of 100 cases, if each consumer
// is off by its own standard uncertainty, independently of the others, and the supply is off for
// all it feeds alike.
#pragma once
#include "energy/meter.h"

namespace bead {

struct Interval {
    double low = 0, high = 0;  // J
};

Interval interval_95(const Energy& energy, const PowerModel& power);

}  // namespace bead
