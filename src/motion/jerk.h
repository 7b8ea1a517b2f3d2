// Classic jerk: the step of an axis' speed that a corner may ask for, mm/s.
#pragma once
#include <algorithm>
#include <cmath>

#include "motion/block.h"

namespace bead {

// Of an axis' speed from p to q: the difference when it goes on in its direction, else it has to
// stop and start again and the larger part counts.
inline double jerk_of(double p, double q) {
    const double a = std::abs(p), b = std::abs(q);
    return p * q > 0 ? std::abs(a - b) : std::max(a, b);
}

// By how much to slow down, 0 … 1, so that no axis' step from p·before to q·after exceeds its jerk.
inline double jerk_factor(const PerAxis<double>& p, double before, const PerAxis<double>& q,
                          double after, const PerAxis<double>& most) {
    double factor = 1;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double jerk = jerk_of(before * p[i], after * q[i]);
        if (jerk > most[i]) factor = std::min(factor, most[i] / jerk);
    }
    return factor;
}

}  // namespace bead
