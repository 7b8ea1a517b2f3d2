// How sure an energy is: the range that holds the true value in 95 of 100 cases, if each consumer
// is off by its own standard uncertainty, independently of the others, and the supply is off for
// all it feeds alike.
#pragma once
#include "energy/published.h"
#include "energy/report.h"
#include "machine/power.h"

namespace bead {

struct Interval {
    double low = 0, high = 0;  // J
};

Interval interval_95(const Energy& energy, const PowerModel& power);

// Of the published model, and of its standing form with the same coefficients: what its fit to ten
// prints leaves open (their covariance, and the residual of a single print), by Student's t with
// six degrees of freedom. Narrow only near those prints: a quarter of an hour to an hour, 20-80
// mm/s, one machine.
Interval published_interval_95(const Features& features);
Interval standing_interval_95(const Features& features, double usual_speed = 80);

}  // namespace bead
